// Executes a block: reads it, shows it to the machine's logic, evaluates, plans and executes it. Used by the rest of control.

#include "control/interpreter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/construct_in_place.h"
#include "base/tolerance.h"
#include "control/flow/file_end.h"

namespace kadr {

// NOLINTNEXTLINE(readability-function-size): sets up all parts of the interpreter in one place
Interpreter::Interpreter(const ControlDef& control, std::unique_ptr<ControlDef> own, const Setup& setup, Program program,
                         const RunLimits& limits, std::shared_ptr<Commons> commons)
    : Emitter(control, std::move(own), std::move(program), limits), stop_(limits.stop) {
  block = &first_block;
  modal.rows.fill(-1);
  dialect = make_dialect(*this, setup, limits, std::move(commons));
  read_setup(setup);
  start_modal(setup);
}

namespace {

/// Returns true if holds_before() does not allow the block just read to be executed now; the block is then read again later. If the block
/// may be executed, its line is recorded in line_marks.
bool is_held(Interpreter& m, const std::optional<Flow::Mark>& before) {
  const bool asks = before && m.holds_before != nullptr && *m.holds_before && !m.program().in_body();
  if (asks && (*m.holds_before)(m.origin)) {
    m.flow.unread(*before);
    return true;
  }
  if (m.line_marks != nullptr) m.line_marks->note(m.program().in_body() ? std::uint16_t{1} : m.origin.file, m.origin.line);
  return false;
}

}  // namespace

Interpreter::~Interpreter() = default;

Status SteppedCycle::finish(Interpreter&) const { return {}; }

void Interpreter::begin_batch(ActionBatch& to) {
  to.clear();
  batch = &to;
  motion_run_.end();  // between two calls of run() any mode or table may have changed, so the fast path ends
  if (!needs_frames) return;
  needs_frames = false;
  emit(frame_change());
  if (modal.surface_speed) emit(surface_speed());
}

/// Executes a step that must precede the next block: a step of a canned cycle, or of the end of an observed block. Returns false if there
/// is no such step.
bool Interpreter::continues_last() {
  if (cycling()) {
    if (const Status status = next_of_cycle(); !status) fail_with(status.error());
    return true;
  }
  if (waiting_count_ != 0) {
    if (const Status status = after_cycle(); !status) fail_with(status.error());
    return true;
  }
  if (phase_ != RunPhase::end_of_block) return false;
  end_block();
  return true;
}

/// Executes a step of the dialect's unfinished work. Returns true if the next block must still wait.
bool Interpreter::waits_for_dialect() {
  if (!dialect->has_unfinished()) return false;
  const auto waits = dialect->finish(*this);
  if (!waits) fail_with(waits.error());
  return !waits || *waits;
}

/// Handles the end of a file. `last`: the block before the end, for reports. Returns nullopt if only an entered line (MDI) has ended.
std::optional<Control::State> Interpreter::close_file(Block* last) {
  block = last;
  if (flow.depth() <= flow.entered_depth() && flow.leave_entered()) return std::nullopt;
  if (const Status closed = end_of_file(); !closed) {
    fail_with(closed.error());
    return is_stopped() ? Control::State::stopped : Control::State::running;
  }
  flow.end();
  return Control::State::ended;
}

/// Executes the block that was read, or reports why it cannot be read. Returns nullopt if the run continues with the next block.
std::optional<Control::State> Interpreter::take_read(const Result<BlockReader::Got>& got) {
  if (got && !reads_clock && !block->no_clock && !block->code.empty()) {
    if (dialect->reads_clock(*block)) {
      reads_clock = each_block = true;
      phase_ = RunPhase::same_block;
      return Control::State::running;
    }
    block->no_clock = true;
  }
  if (!got && block->marker == Marker::program_start) flow.set_started(true);  // the block is damaged, but its sign % was read
  if (!block->warnings.empty()) [[unlikely]] {
    for (const Alarm& w : block->warnings) warn(w);
    block->warnings.clear();  // a block that a loop executes again must not report its warnings again
  }
  if (got && block->skip != 0 && asks_to_skip()) return Control::State::running;
  if (!got && dialect->skips_unread() && block->skip != 0 && skip_switches[block->skip % skip_switches.size()]) return std::nullopt;
  if (got) {
    take_block();
    skips_it.reset();
    if (unknown_position != 0) [[unlikely]]
      note_placed();
    motion_run_.note(*this);
    if (block_states_) [[unlikely]]
      block_states_->note(origin.number, *this);
  } else {
    damaged = true;
    motion_run_.end();
    fail_with(got.error());
  }
  return needs_probe ? std::optional(Control::State::needs_probe) : std::nullopt;
}

Control::State Interpreter::run(ActionBatch& to) {
  begin_batch(to);
  const bool looked_at = line_marks != nullptr || (holds_before != nullptr && *holds_before);
  const std::uint64_t until = flow.blocks() + most_unseen;
  while (to.size() < batch_size && !is_stopped() && !needs_probe && !(each_block && !to.empty()) && !stop_.requested()) {
    if (waiting.meeting) return Control::State::waiting;
    if (continues_last()) continue;
    if (flow.ended()) return Control::State::ended;
    if (waits_for_dialect()) continue;
    std::optional<Flow::Mark> before;
    if (looked_at) [[unlikely]] {
      if (line_marks != nullptr && flow.blocks() >= until) break;
      if (phase_ != RunPhase::same_block) before = flow.mark();
    }
    Block* const last = block;
    const auto got = phase_ == RunPhase::same_block ? Result<BlockReader::Got>(BlockReader::Got::block) : flow.next(block);
    phase_ = RunPhase::next_block;
    if (got && *got == BlockReader::Got::end) {
      if (const auto state = close_file(last)) return *state;
      continue;
    }
    if (!flow.in_body()) construct_in_place(origin, [this] { return origin_of_block(); });
    else origin.number = static_cast<std::uint32_t>(flow.blocks());
    if (looked_at && is_held(*this, before)) [[unlikely]]
      return Control::State::held;
    if (motion_run_.is_on() && got && motion_run_.take(*this)) [[likely]] {
      if (block_states_) block_states_->note(origin.number, *this);
    } else if (const auto state = take_read(got)) {
      return *state;
    }
  }
  return is_stopped() ? Control::State::stopped : needs_probe ? Control::State::needs_probe : Control::State::running;
}

void Interpreter::watch_states() {
  if (!block_states_) block_states_ = std::make_unique<BlockStates>();
  block_states_->note(origin.number, *this);
}

void Interpreter::execute_statement() {
  journal.begin();
  pass_varies = true;
  if (const auto done = dialect->statement(*this); !done) fail_with(done.error());
  else report_changes();
}

void Interpreter::take_block() {
  if (returns_from_entered()) [[unlikely]]
    return fail_with(alarm(AlarmId::return_without_call, block->where));
  if (is_watched()) [[unlikely]]
    return watch_block();
  if (const Status status = execute_block(); !status) fail_with(status.error());
  else report_changes();
  if (!is_stopped() && dialect->watches_blocks()) phase_ = RunPhase::end_of_block;  // M96 in this block may have enabled interrupt macros
}

/// Returns true if the machine's logic observes each block, or if an interrupt macro may be called.
bool Interpreter::is_watched() const { return (on_block != nullptr && *on_block) || dialect->watches_blocks(); }

/// Executes a block that is observed: the machine's logic and an interrupt macro act before it. end_block() follows when the actions of the
/// block have been passed to the caller (nct 23.4). A block that an interrupt macro has delayed is read again, and is then executed without
/// another interrupt. INFERRED: without this rule a signal that stays on would delay the block permanently.
void Interpreter::watch_block() {
  const bool skipped = is_skipped();
  in_interrupt = dialect->in_interrupt();
  const bool put_off = resumed && !in_interrupt && *resumed == block->position;
  if (put_off || !in_interrupt) resumed.reset();
  Result<bool> instead = false;
  if (!put_off && !skipped) {
    if (on_block != nullptr && *on_block) (*on_block)(origin, false);
    if (flow.ended()) return;  // the run ends if the machine's logic has switched the power off
    instead = dialect->interrupt(*this, BlockMoment::start);
  }
  if (instead && *instead) {
    resumed = block->position;
    return;
  }
  if (block->skip != 0 && !skipped) dialect->note_skip_mark(*this);
  const std::uint8_t skip = skipped ? block->skip : std::exchange(block->skip, std::uint8_t{0});  // the skip switch was evaluated already
  const Status status = instead ? execute_block() : Status(fail(instead.error()));
  if (!skipped) block->skip = skip;
  if (!status) fail_with(status.error());
  else report_changes();
  if (!is_stopped() && !skipped) phase_ = RunPhase::end_of_block;
}

/// Executes what follows an observed block: the interrupt macro, then the machine's logic.
void Interpreter::end_block() {
  phase_ = RunPhase::next_block;
  if (!in_interrupt) {
    const auto called = dialect->interrupt(*this, BlockMoment::end);
    if (!called) fail_with(called.error());
  }
  if (!is_stopped() && on_block != nullptr && *on_block) (*on_block)(origin, true);
}

/// Switches the power off and on (nct 23.5): the program ends.
void Interpreter::power_cycle() {
  if (!dialect->lose_power(*this)) return;
  stop_cycles();
  waiting_count_ = 0;
  waiting.meeting.reset();
  close_block();
  flow.end();
}

/// Handles the end of the program's file, which also ends the program. Fails if a call or a repetition is open.
Status Interpreter::end_of_file() {
  origin.line = std::max<std::uint32_t>(origin.line, 1);  // an empty file has no line, so the report names line 1
  const auto done = dialect->end_of_file(*this);
  if (!done) return fail(done.error());
  if (*done) return {};
  if (flow.depth() == 0) {
    // True if the end of the file seems to be missing: the file has no block, or lacks the closing sign %.
    const bool cut_off = !flow.started() || (def.grammar.percent_ignored && lacks_closing_sign(flow.file(0)));
    if (def.behaviour.end_required || cut_off) warn(warning(AlarmId::end_missing, {}));
    return {};
  }
  const CallFrame frame = flow.frames().back();
  const AlarmId id = frame.kind == CallFrame::Kind::repetition ? AlarmId::repeat_end_missing : AlarmId::subprogram_end_missing;
  return fail(alarm(id, {}, double(frame.kind == CallFrame::Kind::repetition ? frame.caller.line : frame.name)));
}

Status Interpreter::next_of_cycle() {
  if (canned_cycle_run.active()) return canned_cycle_run.next(*this);
  if (ellipse_run.active()) return ellipse_run.next(*this);
  const auto more = running->next(*this);
  if (!more) return fail(more.error());
  if (*more) return {};
  finished = std::move(running);
  return finished->finish(*this);
}

void Interpreter::stop_cycles() {
  canned_cycle_run.stop();
  ellipse_run.stop();
  running.reset();
}

void Interpreter::fail_with(const Alarm& failed) {
  stop_cycles();
  waiting_count_ = 0;
  close_block();
  report = fault_place ? report_of(failed, fault_place->origin, fault_place->text) : report_of(failed, origin, block->text);
  fault_place.reset();
  if (follows_refused_motion(failed.id)) return keep_from_faulty_block();
  phase_ = RunPhase::stopped;
  dialect->failed(*this);
}

Status Interpreter::execute_block() {
  journal.begin();
  if (use.watches()) [[unlikely]]
    use.pass(origin);
  if (block->marker != Marker::none || skipping_section || !flow.started()) {
    KADR_TRY(structure());
    if (skipping_section || flow.ended()) return {};
  }
  if (block->skip != 0) {
    pass_varies = true;
    use.note(UseKind::skip_switch, block->skip % 10U, origin);
    dialect->note_skip_mark(*this);
    if (is_skipped()) return {};
  }
  const bool data = block->has_number && dialect->takes_data();
  if (def.machine_axes() && !data) KADR_TRY(check_numbers());
  if (block->empty() && block->comments.empty() && !data) return {};
  if (block->statement.kind != StatementKind::none) {
    pass_varies = true;
    const auto done = dialect->statement(*this);
    if (!done) return fail(done.error());
    if (*done) return {};
  }
  return attempt();
}

/// Checks that N and O are in their ranges (nct 1.1). At the start of a program O is the program number.
Status Interpreter::check_numbers() {
  const auto check = [&](char letter, std::uint32_t value, Span where) -> Status {
    const AddressRow& row = def.address(letter);
    if (value >= row.least && value <= row.most) return {};
    return fail(alarm(AlarmId::value_out_of_range, where, letter, double(value)));
  };
  if (block->has_number) KADR_TRY(check('N', block->number, block->number_where));
  if (block->marker != Marker::label) return {};
  if (block->label == 0 && def.address('O').least == 0) {  // CAM systems write O0, which is no alarm (spec/fanuc 1.1)
    warn(warning(AlarmId::program_number_zero, block->where));
    return {};
  }
  return check('O', block->label, block->where);
}

/// Executes all words of the block. After an alarm all of them are undone.
Status Interpreter::attempt() {
  const std::size_t actions = batch->size();
  state_saved_ = false;
  block_exact = block_machine_coordinates = false;
  waiting_count_ = 0;
  flow_before_.reset();
  shape_ = shapes_.of(def, *block);
  dialect->begin_block(*this);
  if (sets_variables_only(*block)) return assign_alone();
  if (!block->code.empty() && macro_variables == nullptr) keep_state();  // an assignment among other words can change any state
  Status status = words();
  if (!status) undo_block(actions);
  return status;
}

Status Interpreter::words() {
  KADR_TRY(evaluate_words());
  const auto done = dialect->takes_block(*this);
  if (!done) return fail(done.error());
  if (*done) return {};
  KADR_TRY(plan());
  if (plan_now_->passed_over != 0) [[unlikely]]
    warn_passed_over(plan_now_->passed_over);
  const BlockChanges changes = each_block ? BlockChanges::anything : dialect->changes_of(*this, *plan_now_);
  if (changes == BlockChanges::anything) keep_state();
  else if (changes != BlockChanges::position) keep_simple_state();
  if (changes == BlockChanges::cycle) journal.keep(cycle_memory);
  KADR_TRY(execute(*plan_now_));
  if (state_saved_) {
    KADR_TRY(check_place());
    KADR_TRY(check_work_offset_kept());
  }
  return dialect->after_block(*this);
}

/// Finds or makes the plan of the block. A plain block has the plan of its shape. A block that a loop executes again has the plan of its
/// last execution, if nothing that the plan depends on has changed.
Status Interpreter::plan() {
  const std::int16_t motion_row = dialect->motion_row(*this);
  if (ShapeFacts* const facts = shape(); facts != nullptr) [[likely]] {
    plan_now_ = &facts->plan;
    if (facts->planned && facts->motion_row == motion_row) return {};
    facts->planned = false;
    KADR_TRY(plan_block(def, letters, *block, motion_row, facts->plan));
    facts->planned = true;
    facts->motion_row = motion_row;
    return {};
  }
  plan_now_ = &plan_;
  if (!block->repeated || block->codes_vary) return plan_block(def, letters, *block, motion_row, plan_);
  if (plans_.empty()) plans_.resize(kept_plans);
  KeptPlan& kept = plans_[reinterpret_cast<std::uintptr_t>(block) / sizeof(Block) % kept_plans];  // NOLINT: the address is a hash key here
  plan_now_ = &kept.plan;
  if (kept.block == block && kept.letters == block->letters && kept.motion_row == motion_row) return {};
  kept.block = nullptr;
  KADR_TRY(plan_block(def, letters, *block, motion_row, kept.plan));
  kept.block = block;
  kept.letters = block->letters;
  kept.motion_row = motion_row;
  return {};
}

BlockChanges BlockContext::changes_of_block(const Plan& plan) const {
  if (!plan.moves_only || modal.polar || !transform.identity) return BlockChanges::anything;
  return modal.motion == MotionMode::cycle ? BlockChanges::cycle : BlockChanges::position;
}

/// Checks that shifts and scale factors have not moved the tool to a coordinate that the control cannot represent.
Status Interpreter::check_place() const {
  constexpr double most = 4 * farthest;  // limit, mm or degrees; above `farthest`, because origin, tool length and coordinate may cancel
  for (std::size_t a = 0; a < axis_count; ++a)
    for (const double v : {frames.origin[a], frames.length[a], position.programmed[a], position.work[a], position.machine[a]})
      if (!(std::fabs(v) <= most)) return fail(alarm(AlarmId::position_out_of_range, block->where, axis_names[a], v));
  return {};
}

/// Checks that no code changes the work offset during cutter compensation (2С42 6.4.1, Mach3 10.7.18; INFERRED for every code).
Status Interpreter::check_work_offset_kept() const {
  if (dialect->zero_may_move() || modal.radius_side == 0 || frames.origin == before_.frames.origin) return {};
  return fail(alarm(AlarmId::compensation_zero, block->where));
}

}  // namespace kadr
