// Executes the functions of a planned block in their order. If one of them fails, the whole block is undone, so that a faulty block has no
// effect.

#include "control/functions/cutter_compensation.h"
#include "control/interpreter.h"

namespace kadr {
namespace {

bool is(const CodeRow* row, std::uint8_t fact) { return row != nullptr && traits_of(row->function).is(fact); }

/// Returns true if the code ends the program, a subprogram or a repetition.
bool ends(const CodeRow* row) { return is(row, function_fact::ends); }

/// Returns true if the code stops the run, or ends the program, a subprogram or a repetition.
bool ends_or_stops(const CodeRow* row) { return is(row, function_fact::ends | function_fact::stops); }

}  // namespace

void Emitter::show_messages() {
  for (const Span comment : block->comments) {
    const std::string_view text = block->text_of(comment);
    if (text.size() > 4 && (text.starts_with("MSG,") || text.starts_with("msg,"))) {
      Span all;
      emit(Message{flow.shown(text.substr(4), all)});
    }
  }
}

Status Interpreter::execute(const Plan& plan) {
  if (def.grammar.expressions && !block->comments.empty()) KADR_TRY(dialect->comments(*this));
  block_axes_taken = plan.axes_taken;
  bool motion_began = false;
  std::size_t calls_before = ~std::size_t{0};
  bool ended_subprogram = false;
  for (std::uint32_t i = 0; i < plan.count; ++i) {
    const PlanItem& item = plan.items[i];
    const Phase phase = phase_of(item);
    if (phase == Phase::motion && !motion_began) {
      motion_began = true;
      if (unsupported != 0) KADR_TRY(modes_served(item));
      KADR_TRY(contour_allows_motion(*this));
    }
    if (phase == Phase::flow && (each_block || i + 1 < plan.count) && !flow_before_) flow_before_ = flow.place();
    // In `M17 M2` M17 has ended the subprogram; M2 ends only the section of subprograms, so it is not executed.
    if (row_of(item) != nullptr && ended_subprogram && ends(row_of(item))) break;
    const bool called = calls_before < flow.depth();
    const bool waits = running != nullptr ? waits_for(*running, item) : cycling() && ends_or_stops(row_of(item));
    if (called && ends(row_of(item))) {
      KADR_TRY(end_possible(item, calls_before));
      keep_for_return(item);
      ended_subprogram = row_of(item)->function == Function::subprogram_end;
    } else if (waits) {
      if (ends(row_of(item))) KADR_TRY(end_possible(item, flow.depth()));
      waiting_[waiting_count_++] = static_cast<std::uint8_t>(i);
      ended_subprogram = row_of(item) != nullptr && row_of(item)->function == Function::subprogram_end;
    } else {
      const bool calls = phase == Phase::flow && is_call(item);
      if (calls) calls_before = flow.depth();
      KADR_TRY(execute(item));
      ended_subprogram = ended_subprogram || (row_of(item) != nullptr && row_of(item)->function == Function::subprogram_end);
    }
  }
  return {};
}

Status Interpreter::execute(const PlanItem& item) {
  const CodeRow* const row = row_of(item);
  const Word* const w = item.word == no_word ? nullptr : &block->words[item.word];
  const Function function = row != nullptr ? row->function : def.address(item.address).function;
  dialect->before_function(*this, function);
  // The number of the code is copied before its function is executed, because a jump may make another block the current one.
  const std::int32_t code = w != nullptr ? w->code : -1;
  if (row != nullptr && row->reported) report_to_machine(code);
  KADR_TRY(handler_of(function)(*this, {row, w, w != nullptr ? w->where : block->where}));
  if (row != nullptr && row->modal && row->group != 0) modal.rows[row->group] = item.row;
  if (row != nullptr) dialect->after_code(*this, *row, code);
  return {};
}

bool Interpreter::execute_call(std::uint8_t word) {
  const Word& w = block->words[word];
  const CodeRow& row = def.codes[static_cast<std::size_t>(def.row_of(w.address, w.code))];
  if (row.function == Function::return_program) {
    const CallFrame* const top = flow.innermost();
    const bool plain = top != nullptr && (top->kind == CallFrame::Kind::macro || top->kind == CallFrame::Kind::subprogram);
    // the general execution of blocks (execute()) handles the other cases: M99 of a main program or of an interrupt macro, and M99 P
    if (!plain || top->return_to >= 0) return false;
  }
  journal.begin();
  const std::size_t actions = batch->size();
  if (!evaluate_words()) return false;
  if (row.reported) report_to_machine(w.code);
  if (!handler_of(row.function)(*this, {&row, &w, w.where})) {
    batch->cut(actions);
    return false;
  }
  dialect->after_code(*this, row, w.code);
  dialect->note_line(*this);
  return true;
}

void Emitter::report_to_machine(std::int32_t code) {
  MachineFunction function{static_cast<std::uint32_t>(code / 10)};
  function.by_control = true;
  emit(function);
}

/// Returns true if a function of the block waits for the end of the block's canned cycle. In the block of a drilling cycle M0 acts after
/// operation 1, and the end of the program follows the last drilled hole. In the block of a turning cycle every function that follows the
/// motion waits.
bool Interpreter::waits_for(const SteppedCycle& cycle, const PlanItem& item) const {
  if (cycle.functions_first()) return ends(row_of(item));
  return def.order[static_cast<std::size_t>(phase_of(item))] > def.order[static_cast<std::size_t>(Phase::motion)];
}

bool Interpreter::is_call(const PlanItem& item) const {
  const CodeRow* const row = row_of(item);
  const Function f = row != nullptr ? row->function : def.address(item.address).function;
  return traits_of(f).is(function_fact::calls);
}

/// Checks that an end of the program or subprogram that must wait will be possible later. If the end will not be possible, the block fails
/// now, before it has had any effect.
///   depth  number of open calls and repetitions around the block
Status Interpreter::end_possible(const PlanItem& item, std::size_t depth) const {
  const Span at = block->words[item.word].where;
  const CallFrame* const around = depth == 0 ? nullptr : &flow.frames()[depth - 1];
  const bool in_repetition = around != nullptr && around->kind == CallFrame::Kind::repetition;
  switch (row_of(item)->function) {
    case Function::repetition_end: return in_repetition ? Status() : Status(fail(alarm(AlarmId::repeat_end_alone, at)));
    case Function::subprogram_end:
      if (around == nullptr) return fail(alarm(AlarmId::return_without_call, at));
      break;
    case Function::program_end:
    case Function::tape_end:
      if (around != nullptr && !in_repetition && def.has_sections())
        return fail(alarm(AlarmId::subprogram_end_missing, at, double(around->name)));
      break;
    default: return {};
  }
  return in_repetition ? Status(fail(alarm(AlarmId::repeat_end_missing, at, double(around->caller.line)))) : Status();
}

/// Stores a code that ends the calling block, such as M17 in `L03 M17`: the subprogram L03 is executed first, and M17 is executed on return
/// (2С42 6.3.4, 6.3.5).
void Interpreter::keep_for_return(const PlanItem& item) {
  for (std::int16_t& row : flow.frames().back().then)
    if (row < 0) {
      row = item.row;
      return;
    }
}

/// Fails a motion while a mode is in force that Kadr does not support. A measuring motion is allowed: its own function checks the modes
/// (nct 21.1).
Status Interpreter::modes_served(const PlanItem& item) const {
  const CodeRow* const moves = row_of(item);
  if (moves != nullptr && (moves->function == Function::measure || moves->function == Function::measure_length)) return {};
  for (std::size_t group = 0; group < most_groups; ++group) {
    if ((unsupported >> group & 1u) == 0 || modal.rows[group] < 0) continue;
    const CodeRow& row = def.codes[static_cast<std::size_t>(modal.rows[group])];
    if (!row.works) return fail(alarm(AlarmId::not_available, block->where, row.code));
  }
  return {};
}

/// Executes the functions of the block that wait for the end of its canned cycle. M0 and M2, for example, follow the last drilled hole
/// (order of execution: motion, stop, flow).
Status Interpreter::after_cycle() {
  const std::size_t count = waiting_count_;
  waiting_count_ = 0;
  for (std::size_t i = 0; i < count; ++i) KADR_TRY(execute(plan_now_->items[waiting_[i]]));
  return {};
}

void Interpreter::keep_state() {
  if (state_saved_) return;
  state_saved_ = true;
  before_ = *this;
  dialect->keep(*this);
}

/// Saves only the motion modes. This is enough to undo a block that has only motions and feeds, or only calls; keep_state() saves the whole
/// state.
void Interpreter::keep_simple_state() { journal.keep<MotionModal>(modal); }

/// Undoes a faulty block completely (docs/architecture.md, "An alarm undoes its block").
void Interpreter::undo_block(std::size_t actions) {
  batch->cut(actions);
  needs_probe = false;
  stop_cycles();
  waiting_count_ = 0;
  if (flow_before_) flow.back_to(*flow_before_);
  if (state_saved_) static_cast<ControlState&>(*this) = before_;
  dialect->undo_block(*this);
  journal.undo();  // the journal has older values than the copies restored above, so it is undone after them
  if (state_saved_) {
    (void)variables.consume_frames_changed();
    // With a parameter file the variables store lengths in the machine's unit, also in inch mode (spec/linuxcnc 1.1).
    variables.inch = modal.inch && !def.has_parameter_file();
  }
  dialect->block_undone(*this);
}

void Interpreter::refused() {
  if (batch != nullptr) undo_block(0);
  state_saved_ = false;
  close_block();
  if (block_states_) block_states_->note(origin.number, *this);
  dialect->failed(*this);
}

void Interpreter::run_modes(std::initializer_list<Function> functions) {
  for (const Function function : functions)
    for (std::size_t i = 0; i < def.codes.size(); ++i) {
      const CodeRow& row = def.codes[i];
      if (row.function != function) continue;
      if (function == Function::rapid) {
        modal.motion = MotionMode::rapid;
        modal.motion_row = static_cast<std::int16_t>(i);
      } else {
        (void)handler_of(function)(*this, {&row, nullptr, block->where});
      }
      if (row.group != 0) modal.rows[row.group] = static_cast<std::int16_t>(i);
      break;
    }
}

}  // namespace kadr
