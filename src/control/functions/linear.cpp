// G0, G1 and other straight motions: polar mode, machine coordinates, reference points, probe.

#include <cmath>

#include "base/tolerance.h"
#include "control/functions/cutter_compensation.h"
#include "control/functions/functions.h"
#include "control/functions/probe_unstated.h"

namespace kadr {
namespace {

constexpr std::uint64_t x_bit = letter_bit('X');
constexpr std::uint64_t y_bit = letter_bit('Y');

/// Reads polar words. X is the radius and Y the angle about the pole (Mach3 10.7.6). A radius or angle without a word keeps its last value.
void polar_target(BlockContext& m, Axes& to, AxisMask& named) {
  if ((m.block->letters & (x_bit | y_bit)) == 0) return;
  Modal& modal = m.modal;
  if (m.has('X')) modal.polar_radius = (modal.absolute ? 0.0 : modal.polar_radius) + m.length_value('X');
  if (m.has('Y')) modal.polar_angle = (modal.absolute ? 0.0 : modal.polar_angle) + m.value('Y');
  const SinCos turn = sincos_deg(modal.polar_angle);
  to[0] = modal.pole.x + modal.polar_radius * turn.cos;
  to[1] = modal.pole.y + modal.polar_radius * turn.sin;
  named |= 3u;
}

/// G53 with G0 or G1: the axis words are machine coordinates (Mach3 10.7.17).
Status machine_motion(Emitter& m, MotionKind kind) {
  Axes to = m.position.machine;
  AxisMask named = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    const Word* const w = m.letters.axis_letter[a] != 0 ? m.word(m.letters.axis_letter[a]) : nullptr;
    if (w == nullptr) continue;
    const bool is_length = m.def.address(w->address).unit == WordUnit::length;
    const double half = (m.modal.diameter >> a & 1u) != 0 ? 0.5 : 1.0;
    to[a] = m.value(w->address) * (is_length ? m.unit_scale() : 1.0) * half;
    named |= 1u << a;
    if (!(std::fabs(to[a]) <= farthest)) return fail(alarm(AlarmId::position_out_of_range, w->where, w->address, to[a]));
  }
  return m.to_machine(kind, to, named, 0);
}

Status straight(Emitter& m, const Call& call, MotionKind kind, MotionMode mode) {
  if (call.row->modal) {
    m.modal.motion = mode;
    m.modal.motion_row = static_cast<std::int16_t>(call.row - m.def.codes.data());
  }
  m.cycle_memory.row = -1;
  if (m.block_axes_taken) return {};
  if (m.dialect->shapes_lines(m)) return m.dialect->straight(m, call, kind);
  AxisMask named = 0;
  Axes to;
  KADR_TRY(m.target(to, named));
  if (m.modal.polar) polar_target(m, to, named);
  if (m.dialect->adds_to_motion(m)) {
    const auto added = m.dialect->add_to_motion(m);
    if (!added) return fail(added.error());
    named |= *added;
  }
  if (named == 0 && !moves_without_words(m)) return {};  // a block that has only the code sets the mode, and moves nothing
  if (kind == MotionKind::feed) KADR_TRY(m.feed_known(call.where));
  if (m.block_machine_coordinates) return machine_motion(m, kind);
  if (m.dialect->only_shifts(m)) {
    m.move_to(to, m.transform.to_work(to), named);
    return {};
  }
  return m.straight(kind, to, named);
}

bool axes_taken_by_code(const BlockContext& m) {
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    const std::int32_t row = w.address == 'G' ? m.def.row_of('G', w.code) : -1;
    if (row >= 0 && (m.def.codes[static_cast<std::size_t>(row)].takes & m.letters.axes) != 0) return true;
  }
  return false;
}

/// Checks that cutter compensation is off, for motions to machine points or reference points and for probe motions (Mach3 10.7.12; INFERRED
/// for the 2С42).
Status no_compensation(const BlockContext& m, const Call& call) {
  if (m.modal.radius_side == 0) return {};
  return fail(alarm(AlarmId::compensation_active, call.where, call.row->code));
}

/// Returns the axes that have a word in the block, whatever its value; all axes if no axis has a word.
AxisMask named_axes(const BlockContext& m) {
  AxisMask named = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (m.letters.axis_letter[a] != 0 && m.has(m.letters.axis_letter[a])) named |= 1u << a;
  return named != 0 ? named : (1u << m.axis_count) - 1;
}

}  // namespace

namespace functions {

Status rapid(Emitter& m, const Call& call) { return straight(m, call, MotionKind::rapid, MotionMode::rapid); }
Status linear(Emitter& m, const Call& call) { return straight(m, call, MotionKind::feed, MotionMode::linear); }

/// G80 (Mach3 10.7.23): fails if the block has axis words and no code that uses them.
Status no_motion(Emitter& m, const Call& call) {
  if (m.def.behaviour.reads_arc_radius() && m.has_axis_words() && !axes_taken_by_code(m)) {
    const Word* first = nullptr;
    for (std::uint32_t i = 0; i < m.block->word_count && first == nullptr; ++i)
      if ((m.letters.axes & letter_bit(m.block->words[i].address)) != 0) first = &m.block->words[i];
    return fail(alarm(AlarmId::no_motion_mode, first->where, first->address));
  }
  m.modal.motion = MotionMode::none;
  m.modal.motion_row = call.row->modal && m.def.behaviour.reads_arc_radius() ? std::int16_t{-1} : m.modal.motion_row;
  m.cycle_memory.row = -1;
  return {};
}

Status machine_coordinates(Emitter& m, const Call& call) {
  const bool straight_coded = m.has_code({Function::rapid, Function::linear});
  const bool other_coded = m.has_code({Function::arc_cw, Function::arc_ccw, Function::cycle, Function::probe, Function::circular_pocket});
  const bool in_force = m.modal.motion == MotionMode::rapid || m.modal.motion == MotionMode::linear;
  if (other_coded || (!straight_coded && !in_force)) return fail(alarm(AlarmId::machine_motion_mode, call.where));
  if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, call.where, "G53"));
  if (!m.has_axis_words()) return fail(alarm(AlarmId::no_axis_word, call.where, "G53"));
  m.block_machine_coordinates = true;
  return {};
}

/// G28, G30 (Mach3 10.7.10): moves at rapid through the programmed point to the home position. arg: 1 home, 2 second home. INFERRED: only
/// the axes that have a word move to the home position; without axis words all axes do so, in one motion.
Status home_through(Emitter& m, const Call& call) {
  KADR_TRY(no_compensation(m, call));
  const std::uint32_t first = m.variables.first(call.row->arg == 2 ? VariableKind::home_second : VariableKind::home);
  AxisMask named = 0;
  if (m.has_axis_words()) {
    Axes through;
    KADR_TRY(m.target(through, named));
    KADR_TRY(m.straight(MotionKind::rapid, through, named));
  }
  Axes home{};
  for (std::size_t a = 0; a < m.axis_count && a < 6; ++a) home[a] = m.variables.raw(first + static_cast<std::uint32_t>(a));
  return m.to_machine(MotionKind::home, home, named_axes(m), 0, call.row->arg == 2 ? EndReference::reference_2 : EndReference::reference_1);
}

/// G28.1 (Mach3 10.7.11): the axes move at feed to their reference switches. The end point of the emitted Motion is the reference point.
Status home_axes(Emitter& m, const Call& call) {
  KADR_TRY(no_compensation(m, call));
  KADR_TRY(m.feed_known(call.where));
  return m.to_machine(MotionKind::home, m.tables.reference[1], named_axes(m), m.modal.feed, EndReference::reference_1);
}

/// G25 (2С42): moves to the machine's reference point at 2000 mm/min.
Status approach_reference(Emitter& m, const Call& call) {
  KADR_TRY(no_compensation(m, call));
  return m.to_machine(MotionKind::home, m.tables.reference[1], named_axes(m), m.def.behaviour.reference_feed, EndReference::reference_1);
}

/// G26 (2С42): moves to a point in machine coordinates; INFERRED: at rapid.
Status machine_point(Emitter& m, const Call& call) {
  KADR_TRY(no_compensation(m, call));
  return machine_motion(m, MotionKind::rapid);
}

/// G31 (Mach3 10.7.12): a probe motion.
Status probe(Emitter& m, const Call& call) {
  const std::uint64_t linear = letter_bit('X') | letter_bit('Y') | letter_bit('Z');
  if ((m.block->letters & linear) == 0) return fail(alarm(AlarmId::no_axis_word, call.where, call.row->code));
  if (m.modal.feed_mode == FeedMode::inverse_time && !m.def.behaviour.probe_in_inverse_time)
    return fail(alarm(AlarmId::probe_feed_mode, call.where));
  KADR_TRY(no_compensation(m, call));
  KADR_TRY(m.feed_known(call.where));
  AxisMask named = 0;
  Axes to;
  KADR_TRY(m.target(to, named));
  double distance = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    const double travel = to[a] - m.position.programmed[a];
    if ((m.def.rotary >> a & 1u) == 0) distance += travel * travel;
    else if (std::fabs(travel) > tol::same_angle)
      return fail(alarm(AlarmId::rotary_motion, m.where(m.letters.axis_letter[a]), m.letters.axis_letter[a]));
  }
  if (std::sqrt(distance) < m.def.behaviour.probe_least_distance)
    return fail(alarm(AlarmId::probe_too_close, call.where, std::sqrt(distance), m.def.behaviour.probe_least_distance));
  if (call.row->modal) {  // no motion code is in force after G38.2, because G0 could hit the part
    m.modal.motion = MotionMode::none;
    m.modal.motion_row = -1;
  }
  m.needs_probe = true;
  m.probe_where = call.where;
  return m.straight(MotionKind::probe, to, named);
}

}  // namespace functions

/// Receives the machine's answer to a probe motion: the contact point, stored in #2000…#2005 (Mach3 10.7.12).
void Interpreter::answer(const ProbeAnswer& answer) {
  pass_varies = true;
  const Status taken = dialect->accept_answer(*this, answer);
  if (!taken) fail_with(taken.error());
}

Status Emitter::note_answer(const ProbeAnswer& answer) {
  needs_probe = false;
  const bool touched = made_contact(*this, answer);
  const std::uint32_t first = variables.first(VariableKind::probe_point);
  for (std::size_t a = 0; a < axis_count; ++a) {
    position.work[a] = answer.at[a];
    position.machine[a] = answer.at[a] + frames.origin[a] + frames.length[a];
    if (touched && first != 0 && a < 6) variables.set_raw(first + static_cast<std::uint32_t>(a), answer.at[a]);
  }
  (void)variables.consume_frames_changed();
  position.programmed = transform.to_programmed(position.work);
  if (!touched) return fail(alarm(AlarmId::probe_no_contact, probe_where));
  return {};
}

}  // namespace kadr
