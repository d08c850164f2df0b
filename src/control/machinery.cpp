#include "control/machinery.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "lang/expression.h"

namespace kadr {
namespace {

/// The instructions' view of the variables.
struct Reading {
  const Variables& variables;
  Result<double> variable(double number, Span where) const { return variables.variable(number, where); }
  Result<double> parameter(int index, Span where) const { return variables.parameter(index, where); }
};

std::uint32_t characters(std::string_view text) {
  return static_cast<std::uint32_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace

Machinery::Machinery(const ControlDef& control, const Setup& setup, Program program, RunLimits limits)
    : def(control), letters(control), variables(control), flow(control, std::move(program), limits) {
  modal.rows.fill(-1);
  read_setup(setup);
  start_modal(setup);
}

Control::State Machinery::run(ActionBatch& to) {
  to.clear();
  batch = &to;
  if (first_frames_) {
    first_frames_ = false;
    emit(FrameChange{frames.origin, frames.length, position.work});
  }
  while (to.size() < batch_size && !stopped_ && !(each_block && !to.empty())) {
    if (cycle_run.active() || ellipse_run.active()) {
      const Status status = cycle_run.active() ? cycle_run.next(*this) : ellipse_run.next(*this);
      if (!status) fail_with(status.error());
      continue;
    }
    if (waiting_count_ != 0) {
      if (const Status status = after_cycle(); !status) fail_with(status.error());
      continue;
    }
    if (flow.ended()) return Control::State::ended;
    const auto got = flow.next(block);
    if (got && *got == BlockReader::Got::end) {
      if (const Status closed = end_of_file(); !closed) {
        fail_with(closed.error());
        break;
      }
      flow.end();
      return Control::State::ended;
    }
    if (!flow.in_body()) origin = origin_of_block();
    if (!got && block.marker == Marker::program_start) flow.started = true;  // damaged, but there
    for (const Alarm& w : block.warnings) warn(w);
    const Status status = got ? execute() : Status(fail(got.error()));
    if (!status) fail_with(status.error());
    if (needs_probe) return Control::State::needs_probe;
  }
  return stopped_ ? Control::State::stopped : Control::State::running;
}

/// The file's end ends the program too; not in the middle of a call or a repetition.
Status Machinery::end_of_file() {
  if (flow.depth() == 0) {
    if (def.behaviour.end_required) warn(warning(AlarmId::end_missing, {}));
    return {};
  }
  const CallFrame frame = flow.frames().back();
  const AlarmId id = frame.kind == CallFrame::Kind::repetition ? AlarmId::repeat_end_missing : AlarmId::subprogram_end_missing;
  return fail(alarm(id, {}, double(frame.kind == CallFrame::Kind::repetition ? frame.caller.line : frame.name)));
}

/// After an end that came too early the open call or repetition is left, so that one fault is not found again and again.
void Machinery::go_on() {
  stopped_ = false;
  keep_from_faulty_block();
  if (report.alarm.id != AlarmId::repeat_end_missing && report.alarm.id != AlarmId::subprogram_end_missing) return;
  const bool at_end_of_file = report.alarm.where.end == 0;
  flow.abandon(at_end_of_file ? std::optional<Position>() : block.position);
}

/// What the faulty block would have left to those behind it, so that one fault is one alarm: a feed, the end of a
/// subprogram or repetition.
void Machinery::keep_from_faulty_block() {
  if (block.position.line != report.origin.line) return;
  const AlarmId id = report.alarm.id;
  const bool of_flow = id == AlarmId::return_without_call || id == AlarmId::repeat_end_alone || id == AlarmId::repeat_end_missing ||
                       id == AlarmId::subprogram_end_missing || id == AlarmId::endless_program;
  if (const Word* const f = block.find('F'); f != nullptr && !(modal.feed_known && modal.feed > 0)) {
    modal.feed_known = true;
    modal.feed = f->value > 0 ? f->value : 1;
  }
  if (of_flow || flow.depth() == 0) return;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    const std::int32_t row = w.address == 'M' && w.code >= 0 ? def.row_of('M', w.code) : -1;
    if (row < 0) continue;
    const Function f = def.codes[static_cast<std::size_t>(row)].function;
    if (f == Function::subprogram_end) (void)flow.end_subprogram(w.where);
    if (f == Function::repetition_end) (void)flow.end_repetition(w.where);
  }
}

void Machinery::fail_with(const Alarm& failed) {
  cycle_run.stop();
  ellipse_run.stop();
  waiting_count_ = 0;
  report = report_of(failed, origin, block.text);
  stopped_ = true;
}

void Machinery::warn(const Alarm& alarm) {
  if (*on_warning) (*on_warning)(report_of(alarm, origin, block.text));
}

AlarmReport Machinery::report_of(const Alarm& alarm, const Origin& at, std::string_view line_text) const {
  AlarmReport r{alarm, flow.file(), {}, at, {}};
  const bool in_body = flow.in_body() && !line_text.empty();
  if (in_body) r.alarm.where = call_where;  // the body stands in no file: the place is the call
  r.line_text = in_body ? call_text : flow.shown(line_text, r.alarm.where);
  if (r.alarm.where.begin <= r.line_text.size())
    r.origin.column = characters(std::string_view(r.line_text).substr(0, r.alarm.where.begin)) + 1;
  for (const CallFrame& frame : flow.frames())
    r.calls.push_back({Flow::name_of(def, frame), frame.caller.line, frame.caller.block, frame.caller.has_block});
  return r;
}

Origin Machinery::origin_of_block() const {
  Origin o;
  o.line = block.position.line;
  o.column = block.where.begin == 0 ? 1 : characters(block.text.substr(0, block.where.begin)) + 1;
  o.block = block.number;
  o.has_block = block.has_number;
  o.main_block = block.main_block;
  o.block_digits = block.number_digits;
  o.depth = static_cast<std::uint8_t>(std::min<std::size_t>(flow.depth(), 255));
  return o;
}

// ---- one block

Status Machinery::execute() {
  if (block.marker != Marker::none || skipping_section_ || !flow.started) {
    KADR_TRY(structure());
    if (skipping_section_ || flow.ended()) return {};
  }
  if (block.skip != 0 && skip_switches[std::min<std::size_t>(block.skip, 9)]) return {};
  if (block.empty() && block.comments.empty()) return {};
  return attempt();
}

/// The block's words carried out, or nothing of them.
Status Machinery::attempt() {
  const std::size_t actions = batch->size();
  moment_taken_ = false;
  block_exact = block_machine_coordinates = false;
  waiting_count_ = 0;
  flow_before_.reset();
  if (!block.code.empty()) {
    take_moment();
    variables.begin_block();
  }
  Status status = words();
  if (!status) take_back(actions);
  return status;
}

Status Machinery::words() {
  KADR_TRY(evaluate_words());
  KADR_TRY(plan_block(def, letters, block, modal.motion_row, plan_));
  if (each_block || !changes_only_position()) take_moment();
  KADR_TRY(carry_out(plan_));
  return moment_taken_ ? check_place() : Status();
}

/// A motion that either fails before anything has changed, or is carried out.
bool Machinery::changes_only_position() const {
  if (!plan_.moves_only || modal.polar || modal.motion == MotionMode::cycle || !transform.identity) return false;
  return !def.behaviour.correctors || !has('L');
}

/// Shifts and factors must not carry the tool beyond what a number of the control can hold.
Status Machinery::check_place() const {
  constexpr double most = 4 * farthest;  // origin, length and coordinate may lie apart
  for (std::size_t a = 0; a < axis_count; ++a)
    for (const double v : {frames.origin[a], frames.length[a], position.programmed[a], position.work[a], position.machine[a]})
      if (!(std::fabs(v) <= most)) return fail(alarm(AlarmId::position_out_of_range, block.where, axis_names[a], v));
  return {};
}

/// '%', sections of subprograms, labels: where a program begins.
Status Machinery::structure() {
  switch (block.marker) {
    case Marker::program_start:
      if (flow.started && !skipping_section_ && flow.depth() == 0 && def.behaviour.ends_reading) {
        warn(warning(AlarmId::end_missing, block.where));
        flow.end();  // the next program of the tape
      }
      flow.started = true;
      skipping_section_ = false;
      return {};
    case Marker::section:
      if (flow.depth() != 0) return fail(alarm(AlarmId::subprogram_end_missing, block.where, double(flow.frames().back().name)));
      skipping_section_ = true;
      return {};
    case Marker::label:
      if (flow.depth() == 0) flow.pass_label(block.label);
      return {};
    default: break;
  }
  constexpr std::uint8_t digits_of_label = 5;  // 2С42 6.3.5: zeros are not dropped
  if (skipping_section_ && block.has_number && block.number_digits != digits_of_label)
    return fail(alarm(AlarmId::too_few_digits, block.number_where, 'N', double(block.number_digits), double(digits_of_label)));
  if (skipping_section_ || flow.started || block.empty()) return {};
  flow.started = true;
  if (!def.grammar.program_start_required) return {};
  return fail(alarm(AlarmId::program_start_missing, {block.where.begin, block.where.begin + 1}));
}

Status Machinery::evaluate_words() {
  if (block.code.empty()) return check_ranges();
  if (!def.behaviour.delayed_assignment) KADR_TRY(assign());
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    Word& w = block.words[i];
    if (!w.expression) continue;
    const auto result = evaluate(block, w.expression, Reading{variables});
    if (!result) return fail(result.error());
    w.value = *result;
    if (def.grammar.word(w.address).code) {
      const double nearest = std::round(w.value * 10);
      const bool is_code = std::fabs(w.value * 10 - nearest) < tol::whole_number && nearest >= 0 && nearest < ControlDef::most_tenths;
      w.code = is_code ? static_cast<std::int32_t>(nearest) : -1;
    }
  }
  KADR_TRY(check_ranges());
  return def.behaviour.delayed_assignment ? assign() : Status();
}

/// All values first, then all assignments: `#1=5 X#1` uses the old #1 (spec/mach3 1).
Status Machinery::assign() {
  assigned_.clear();
  for (const Assignment& a : block.assignments) {
    const auto target = evaluate(block, a.target, Reading{variables});
    if (!target) return fail(target.error());
    const auto value = evaluate(block, a.value, Reading{variables});
    if (!value) return fail(value.error());
    assigned_.push_back(*target);
    assigned_.push_back(*value);
  }
  for (std::size_t i = 0; i < block.assignments.size(); ++i) {
    if (def.grammar.parameter_address != 0) variables.set_parameter(static_cast<int>(assigned_[2 * i]), assigned_[2 * i + 1]);
    else KADR_TRY(variables.set(assigned_[2 * i], assigned_[2 * i + 1], block.assignments[i].where));
  }
  if (variables.take_frames_changed()) change_frames();
  return {};
}

Status Machinery::check_ranges() const {
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    if (!(std::fabs(w.value) <= 1e9)) return fail(alarm(AlarmId::value_out_of_range, w.where, w.address, w.value));
    const AddressRow& row = def.address(w.address);
    if (w.value < row.least || w.value > row.most) return fail(alarm(AlarmId::value_out_of_range, w.where, w.address, w.value));
    if (row.whole && w.value != std::floor(w.value)) return fail(alarm(AlarmId::word_not_integer, w.where, w.address, w.value));
  }
  return {};
}

// ---- words

double Machinery::value(char letter) const {
  const Word* const w = block.find(letter);
  return w == nullptr ? 0.0 : w->value * def.address(letter).scale;
}

bool Machinery::has_code(std::initializer_list<Function> functions) const {
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    const std::int32_t row = w.code < 0 ? -1 : def.row_of(w.address, w.code);
    if (row >= 0 && std::find(functions.begin(), functions.end(), def.codes[static_cast<std::size_t>(row)].function) != functions.end())
      return true;
  }
  return false;
}

Span Machinery::where(char letter) const {
  const Word* const w = block.find(letter);
  return w == nullptr ? block.where : w->where;
}

Result<std::uint32_t> Machinery::whole(char letter, double least, double most) const {
  const double v = value(letter);
  const double nearest = std::round(v);
  if (std::fabs(v - nearest) > tol::whole_number) return fail(alarm(AlarmId::word_not_integer, where(letter), letter, v));
  if (nearest < least || nearest > most) return fail(alarm(AlarmId::value_out_of_range, where(letter), letter, v));
  return static_cast<std::uint32_t>(nearest);
}

// ---- the rest of the contract

void Machinery::check_uncalled(const std::function<void(const AlarmReport&)>& on_fault) {
  auto plan = std::make_unique<Plan>();
  flow.each_uncalled([&](Result<BlockReader::Got> got, const Block& read) {
    Status status = got ? Status() : Status(fail(got.error()));
    Block& looked_at = const_cast<Block&>(read);  // expressions have no value here: codes by expression are left alone
    bool known = true;
    for (std::uint32_t i = 0; i < looked_at.word_count; ++i)
      known = known &&
              !(looked_at.words[i].expression && looked_at.words[i].code < 0 && letters.codes >> (looked_at.words[i].address - 'A') & 1u);
    if (status && known) status = plan_block(def, letters, read, any_motion, *plan);
    Origin at;
    at.line = read.position.line;
    at.block = read.number;
    at.has_block = read.has_number;
    at.block_digits = read.number_digits;
    if (!status) on_fault(report_of(status.error(), at, read.text));
  });
}

Ending Machinery::ending() const {
  Ending e;
  e.position = position.work;
  e.machine_position = position.machine;
  for (std::uint32_t n = 1; n <= variables.highest() && def.grammar.variables != 0; ++n)
    if (variables.is_set(n)) e.variables.emplace_back("#" + std::to_string(n), *variables.variable(n, {}));
  for (int i = 0; i < 10; ++i)
    if (variables.parameter_set(i)) e.variables.emplace_back("R" + std::to_string(i), variables.raw_parameter(i));
  for (const std::string& name : watch_) {
    const auto same = [&](const auto& v) { return v.first == name; };
    if (std::any_of(e.variables.begin(), e.variables.end(), same)) continue;
    const auto read =
        name.starts_with('#') ? variables.variable(std::strtod(name.c_str() + 1, nullptr), {}) : Result<double>(fail(Alarm()));
    if (read) e.variables.emplace_back(name, *read);
    else e.watched_unset.emplace_back(name, true);
  }
  for (std::size_t g = 1; g < def.groups.size(); ++g)
    if (modal.rows[g] >= 0) e.modal.push_back(def.codes[static_cast<std::size_t>(modal.rows[g])].code);
  const auto add = [&](const char* letter, double v) {
    std::string text = std::to_string(v);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    e.modal.push_back(letter + text);
  };
  if (modal.feed_known) add("F", modal.inch && modal.feed_mode != FeedMode::inverse_time ? modal.feed / mm_per_inch : modal.feed);
  add("S", modal.rpm);
  add("T", modal.tool_selected);
  add("D", modal.offset_number);
  add("H", modal.length_number);
  return e;
}

}  // namespace kadr
