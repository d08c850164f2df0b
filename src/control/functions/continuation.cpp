// Decides how a run continues: at the end of a main program with its next pass, and, in `kadr check`, after a faulty block.

#include <algorithm>
#include <span>

#include "control/interpreter.h"

namespace kadr {

/// Returns true if an expression of the block reads a variable, a parameter R or a parameter of the control, or if the block assigns a
/// value to a variable or parameter.
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
    dialect->begin_again();
    return {};
  }
  warn(note(alike ? AlarmId::program_begins_again : AlarmId::passes_done, where, double(done)));
  flow.end();
  return {};
}

/// Returns true if the faulty block could have written a variable, called a subprogram or jumped. If the block could not be read, words in
/// its text decide.
bool Interpreter::may_have_steered() const {
  if (block->statement.kind != StatementKind::none) return true;
  if (!damaged) return has_code({Function::macro_call, Function::macro_modal, Function::call_program});
  const auto holds = [this](std::string_view text) { return block->text.find(text) != std::string_view::npos; };
  return (holds("#") && holds("=")) || holds("IF") || holds("GOTO") || holds("WHILE") || holds("G65") || holds("M98");
}

/// Continues after an alarm. If the end of a subprogram or repetition was missing, the open call or repetition is closed, so that the same
/// fault is not reported again.
void Interpreter::go_on() {
  phase_ = RunPhase::next_block;
  motion_run_.end();
  dialect->note_fault(*this, may_have_steered());
  keep_from_faulty_block();
  damaged = false;
  if (report.alarm.id != AlarmId::repeat_end_missing && report.alarm.id != AlarmId::subprogram_end_missing) return;
  const bool at_end_of_file = report.alarm.where.end == 0;
  if (dialect->leave_call(*this)) return;
  flow.abandon(at_end_of_file ? std::optional<Position>() : block->position);
}

/// Returns true if the alarm probably is a consequence of an earlier fault: a motion was refused, so the tool is not where the block
/// expects it.
bool Interpreter::follows_refused_motion(AlarmId id) const {
  if (unknown_position == 0) return false;
  switch (id) {
    case AlarmId::radius_mismatch:
    case AlarmId::radius_too_small:
    case AlarmId::full_circle_by_radius:
    case AlarmId::arc_radius_zero:
    case AlarmId::rs274_arc:
    case AlarmId::limit_exceeded:
    case AlarmId::jog_target:
    case AlarmId::probe_too_close:
    case AlarmId::cycle_level: return true;
    default: return false;
  }
}

/// Puts in force those codes of a faulty block on which the meaning of the next blocks depends: plane, unit, G90 or G91, motion code.
void Interpreter::keep_modes_of_faulty_block() {
  if (damaged || block->statement.kind != StatementKind::none) return;
  for (std::uint32_t i = 0; i < block->word_count; ++i) {
    const Word& w = block->words[i];
    const std::int32_t place = w.address == 0 || w.code < 0 ? -1 : def.row_of(w.address, w.code);
    if (place < 0) continue;
    const CodeRow& row = def.codes[static_cast<std::size_t>(place)];
    if (!row.modal || row.group == 0 || !row.works) continue;
    const Phase phase = traits_of(row.function).phase;
    const auto number = static_cast<std::int16_t>(place);
    if (traits_of(row.function).is(function_fact::plain_motion)) {
      modal.motion = row.function == Function::rapid    ? MotionMode::rapid
                     : row.function == Function::linear ? MotionMode::linear
                     : row.function == Function::arc_cw ? MotionMode::arc_cw
                                                        : MotionMode::arc_ccw;
      modal.motion_row = modal.rows[row.group] = number;
    } else if (phase == Phase::plane || phase == Phase::distance || phase == Phase::unit) {
      if (handler_of(row.function)(*this, {&row, &w, w.where})) modal.rows[row.group] = number;
    }
  }
}

/// Sets the position to the end point of a refused motion, because the following blocks were written for this point. The end point is
/// unknown if the block could not be read, or if its axis words belong to another code. In this case the axes that the block names are
/// added to unknown_position, and remain there until a block gives them a coordinate.
void Interpreter::assume_meant_position() {
  if (block->statement.kind != StatementKind::none || flow.in_body()) return;
  const bool unread = damaged || block->broken;
  AxisMask named = 0;
  for (std::size_t a = 0; a < axis_count; ++a) {
    const char letter = letters.axis_letter[a];
    if (letter != 0 && (unread ? block->text.find(letter) != std::string_view::npos : has(letter))) named |= AxisMask{1} << a;
  }
  if (named == 0) return;
  const std::span words(block->words.data(), block->word_count);
  const bool is_plain = std::all_of(words.begin(), words.end(), [this](const Word& w) {
    if (w.code < 0) return true;
    const std::int32_t row = w.address == 0 ? -1 : def.row_of(w.address, w.code);
    if (row < 0) return false;
    const FunctionTraits& traits = traits_of(def.codes[static_cast<std::size_t>(row)].function);
    return traits.is(function_fact::plain_motion) || !traits.takes_axes();
  });
  const std::int16_t row = modal.motion_row;
  const bool moves = row >= 0 && traits_of(def.codes[static_cast<std::size_t>(row)].function).is(function_fact::plain_motion);
  Axes to;
  AxisMask by_words = 0;
  const bool is_known = !unread && is_plain && moves && !modal.polar && modal.surface == PathSurface::plane && frames.is_plain() &&
                        (!block->evaluates || evaluate_words()) && target(to, by_words);
  if (!is_known || !within_reach(transform.to_work(to))) return void(unknown_position |= named);
  move_to(to, transform.to_work(to), by_words);
  if (modal.absolute) unknown_position &= ~by_words;
}

/// Removes from unknown_position the axes to which the executed block has given an absolute coordinate, because the positions of these axes
/// are known again.
void Interpreter::note_placed() {
  if (is_stopped() || !modal.absolute || block->statement.kind != StatementKind::none) return;
  for (std::size_t a = 0; a < axis_count; ++a) {
    const char letter = letters.axis_letter[a];
    if (letter != 0 && has(letter) && !word(letter)->incremental) unknown_position &= ~(AxisMask{1} << a);
  }
}

/// Executes those effects of a faulty block that the following blocks need: a feed, the modes, the end point of the motion, the end of a
/// subprogram or repetition. So one fault gives one alarm.
void Interpreter::keep_from_faulty_block() {
  if (block->position.line != report.origin.line) return;
  const AlarmId id = report.alarm.id;
  const bool of_flow = id == AlarmId::return_without_call || id == AlarmId::repeat_end_alone || id == AlarmId::repeat_end_missing ||
                       id == AlarmId::subprogram_end_missing || id == AlarmId::endless_program;
  const Word* const f = block->find('F');
  // In inverse time mode (G93) each block needs its own F, so no feed is assumed in place of a missing F.
  const bool is_missed = id == AlarmId::feed_missing && modal.feed_mode != FeedMode::inverse_time;
  if ((f != nullptr || is_missed) && !(modal.feed_known && modal.feed > 0)) {
    modal.feed_known = true;
    modal.feed = f != nullptr && f->value > 0 ? f->value : 1;
  }
  keep_modes_of_faulty_block();
  assume_meant_position();
  if (of_flow || flow.depth() == 0) return;
  for (std::uint32_t i = 0; i < block->word_count; ++i) {
    const Word& w = block->words[i];
    const std::int32_t row = w.address == 'M' && w.code >= 0 ? def.row_of('M', w.code) : -1;
    if (row < 0) continue;
    const Function f = def.codes[static_cast<std::size_t>(row)].function;
    if (f == Function::return_program) (void)dialect->leave_call(*this);
    if (f == Function::subprogram_end) (void)flow.end_subprogram(w.where);
    if (f == Function::repetition_end) (void)flow.end_repetition(w.where);
  }
}

}  // namespace kadr
