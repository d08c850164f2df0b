// Going on: another pass of a main program; after a faulty block, for people who check.

#include <algorithm>

#include "control/interpreter.h"

namespace kadr {

/// A variable, R or a parameter of the control stands in an expression of the block, or is written.
bool Interpreter::reads_variables() const {
  return !block->assignments.empty() || std::any_of(block->code.begin(), block->code.end(), [](const Instruction& i) {
    return i.op == Op::variable || i.op == Op::variable_at || i.op == Op::parameter || i.op == Op::element || i.op == Op::control_value;
  });
}

Status Interpreter::begin_again(Span where, Position from) {
  const bool logic_acts = on_block != nullptr && *on_block;
  const std::uint32_t done = flow.passes();
  const bool alike = !pass_varies && !logic_acts;
  if (!alike && flow.restart(from)) {
    pass_varies = false;
    if (dialect) dialect->begin_again();
    return {};
  }
  warn(note(alike ? AlarmId::program_begins_again : AlarmId::passes_done, where, double(done)));
  flow.end();
  return {};
}

/// Would the block, had it been right, have written a variable, called or jumped? Of one that could not be read its text tells.
bool Interpreter::may_have_steered() const {
  if (block->statement.kind != StatementKind::none) return true;
  if (!damaged) return has_code({Function::macro_call, Function::macro_modal, Function::call_program});
  const auto holds = [this](std::string_view text) { return block->text.find(text) != std::string_view::npos; };
  return (holds("#") && holds("=")) || holds("IF") || holds("GOTO") || holds("WHILE") || holds("G65") || holds("M98");
}

/// After an end that came too early the open call or repetition is left, so that one fault is not found again and again.
void Interpreter::go_on() {
  stopped_ = false;
  if (dialect) dialect->note_fault(*this, may_have_steered());
  damaged = false;
  keep_from_faulty_block();
  if (report.alarm.id != AlarmId::repeat_end_missing && report.alarm.id != AlarmId::subprogram_end_missing) return;
  const bool at_end_of_file = report.alarm.where.end == 0;
  if (dialect && dialect->leave_call(*this)) return;
  flow.abandon(at_end_of_file ? std::optional<Position>() : block->position);
}

/// What the faulty block would have left to those after it, so that one fault is one alarm: a feed, the end of a
/// subprogram or repetition.
void Interpreter::keep_from_faulty_block() {
  if (block->position.line != report.origin.line) return;
  const AlarmId id = report.alarm.id;
  const bool of_flow = id == AlarmId::return_without_call || id == AlarmId::repeat_end_alone || id == AlarmId::repeat_end_missing ||
                       id == AlarmId::subprogram_end_missing || id == AlarmId::endless_program;
  if (const Word* const f = block->find('F'); f != nullptr && !(modal.feed_known && modal.feed > 0)) {
    modal.feed_known = true;
    modal.feed = f->value > 0 ? f->value : 1;
  }
  if (of_flow || flow.depth() == 0) return;
  for (std::uint32_t i = 0; i < block->word_count; ++i) {
    const Word& w = block->words[i];
    const std::int32_t row = w.address == 'M' && w.code >= 0 ? def.row_of('M', w.code) : -1;
    if (row < 0) continue;
    const Function f = def.codes[static_cast<std::size_t>(row)].function;
    if (f == Function::return_program && dialect) (void)dialect->leave_call(*this);
    if (f == Function::subprogram_end) (void)flow.end_subprogram(w.where);
    if (f == Function::repetition_end) (void)flow.end_repetition(w.where);
  }
}

}  // namespace kadr
