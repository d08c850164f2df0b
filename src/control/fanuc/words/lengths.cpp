// Length compensation and offset numbers: G43, G44, G49, H, D; the side of cutter compensation by G41, G42 (spec/nct/15 15.3, 12 12.5.1).

#include <algorithm>

#include "base/code_literals.h"
#include "control/fanuc/drilling/drilling.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/five_axis/five_axis_functions.h"
#include "control/fanuc/geometry/sides.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"

namespace kadr {

std::uint32_t fanuc::max_offsets(const BlockContext& m) {
  const int most = fanuc_of(m).settings.offset_numbers;
  return most > 0 ? std::min(static_cast<std::uint32_t>(most), m.def.behaviour.offsets) : m.def.behaviour.offsets;
}

Result<std::uint32_t> fanuc::offset_number(const BlockContext& m, char letter) {
  // PS0030 (spec/fanuc 7.1): the offset number is too large
  if (m.has(letter) && m.value(letter) > fanuc::max_offsets(m) && m.def.gives(AlarmId::offset_number_large))
    return fail(alarm(AlarmId::offset_number_large, m.where(letter), m.block->text_of(m.where(letter))));
  const auto number = m.whole(letter, 0, fanuc::max_offsets(m));
  if (!number) return number;
  return fanuc_of(m).offset_meant(letter, *number);
}

namespace {

/// Returns the axes on which the tool length acts (15.3): the axes of the block, Z, or the normal of the plane.
AxisMask length_axes(const BlockContext& m) {
  const int mode = fanuc_of(m).settings.length_axes;
  const auto bit = [](int axis) { return axis >= 0 ? 1u << static_cast<unsigned>(axis) : 0u; };
  if (const int axis = fanuc::drills_along(m); axis >= 0) return bit(axis);
  if (mode == 1) return bit(fanuc::main_axis(m, 3));
  if (mode == 2) return bit(static_cast<int>(m.modal.axes.normal));
  AxisMask axes = 0;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0 || (m.letters.axes & letter_bit(w.address)) == 0) continue;
    const std::size_t a = m.def.address(w.address).axis;
    if (fanuc_of(m).settings.axes[a].role != 0) axes |= 1u << a;
  }
  return axes;
}

/// Returns the shift of an axis by a length of the offset table. For an axis in diameter programming the length is a diameter (5.3, 15.3).
/// The length is halved when it comes into force, for two reasons: the offset table does not state an axis, and G10.9 (diameter
/// programming) must not move the machine.
double shift_by(const BlockContext& m, std::size_t axis, double length) { return fanuc::is_diameter(m, axis) ? length / 2 : length; }

/// G43.7 (15.4): puts the sums of geometry and wear of the turning offset table into force on X, Y, Z at once.
void register_turning(BlockContext& m, std::uint32_t number) {
  const ToolOffset none, &offset = number == 0 || number >= m.tables.offsets.size() ? none : m.tables.offsets[number];
  if (number != 0) m.use.note(UseKind::length, number, m.origin, offset == none);
  const double lengths[] = {offset.length_x + offset.length_x_wear, offset.length_y + offset.length_y_wear, offset.whole_length()};
  for (int role = 1; role <= 3; ++role)
    if (const int main = fanuc::main_axis(m, role); main >= 0) {
      const auto axis = static_cast<std::size_t>(main);
      m.modal.lengths[axis] = shift_by(m, axis, lengths[role - 1]);
    }
}

void register_length(BlockContext& m, std::uint32_t number) {
  if (m.modal.turning_lengths) return register_turning(m, number);
  const double length = number < m.tables.offsets.size() ? m.tables.offsets[number].whole_length() : 0;
  if (number != 0) m.use.note(UseKind::length, number, m.origin, length == 0);
  if (fanuc_of(m).state.five_axis.tip_control != fanuc::TipControl::none) return fanuc::register_tip_length(m, number == 0 ? 0 : length);
  const AxisMask axes = length_axes(m);
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if ((axes >> a & 1u) != 0) m.modal.lengths[a] = number == 0 ? 0 : m.modal.length_sign * shift_by(m, a, length);
}

/// Checks that H is the number of the tool in the spindle, if setting 15 requires this (spec/haas 10). H0 is always allowed, because it
/// ends the compensation.
Status of_tool(const BlockContext& m, std::uint32_t number) {
  const std::uint32_t tool = m.modal.tool;
  if (!fanuc_of(m).settings.length_of_tool || number == 0 || number == tool) return {};
  return fail(alarm(AlarmId::length_of_other_tool, m.where('H'), double(number), double(tool)));
}

}  // namespace

bool fanuc::only_shifts_length(const BlockContext& m) {
  if (m.modal.absolute || !(m.has('H') || m.has_code({Function::length_comp}))) return false;
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (const char letter = m.letters.axis_letter[a]; letter != 0 && m.has(letter) && m.value(letter) != 0) return false;
  return true;
}

namespace functions {

/// Executes G43, G44, G49, G43.7. call.row->arg is 1 for G43, 2 for G44, 0 for G49, 437 for G43.7.
Status length_comp(Emitter& m, const Call& call) {
  if (m.modal.smoothing == 3) return fail(alarm(AlarmId::smoothing_length, call.where, call.row->code));
  const bool turning = call.row->arg == 43.7_g;
  if (turning && !fanuc_of(m).settings.turning_offsets) return fail(alarm(AlarmId::code_unknown, call.where, call.row->code));  // TOL=0
  if (call.row->arg == 0) KADR_TRY(fanuc::may_end_tip_control(m, call));
  // 15.4: the length offsets of a turning tool in X and Y end, because milling offsets have no lengths in X and Y
  if (m.modal.turning_lengths && !turning) m.modal.lengths = {};
  m.modal.turning_lengths = turning;
  fanuc::end_tip_control(m);
  if (call.row->arg == 0) {
    m.modal.length_sign = 0;
    m.modal.lengths = {};
    m.change_frames();
    return {};
  }
  m.modal.length_sign = call.row->arg == 2 ? std::int8_t{-1} : std::int8_t{1};
  if (m.has('H')) {
    const auto number = fanuc::offset_number(m, 'H');
    if (!number) return fail(number.error());
    KADR_TRY(of_tool(m, *number));
    m.modal.length_number = *number;
    macro_b_of(m).state.words.h = *number;
  } else if (!m.has_axis_words() && !turning) {
    return {};
  }
  // Warns that the tool length has no axis to act on. The program was probably written for another control, which would apply the length.
  if (m.has('H') && !turning && length_axes(m) == 0) m.warn(warning(AlarmId::length_no_axis, call.where, call.row->code));
  register_length(m, m.modal.length_number);
  m.change_frames();
  return {};
}

/// Executes H: while G43 or G44 is in force, the new length acts at once; otherwise only the number is stored.
Status length_number(Emitter& m, const Call& call) {
  if (m.has_code({Function::length_comp, Function::tool_lead, Function::tool_orientation})) return {};
  const auto number = fanuc::offset_number(m, 'H');
  if (!number) return fail(number.error());
  KADR_TRY(of_tool(m, *number));
  const bool changes = m.modal.length_number != *number;
  m.modal.length_number = *number;
  macro_b_of(m).state.words.h = *number;
  if (m.modal.length_sign == 0) return {};
  if (changes && !m.modal.turning_lengths && fanuc_of(m).state.five_axis.tip_control == fanuc::TipControl::none && length_axes(m) == 0)
    m.warn(warning(AlarmId::length_no_axis, call.where, m.block->text_of(call.where)));
  register_length(m, *number);
  m.change_frames();
  return {};
}

Status radius_number(Emitter& m, const Call&) {
  const auto number = fanuc::offset_number(m, 'D');
  if (!number) return fail(number.error());
  m.modal.offset_number = *number;
  macro_b_of(m).state.words.d = *number;
  fanuc_of(m).state.tool_radius = m.radius_in_force();
  fanuc::note_tip_radius(m);
  return {};
}

/// Executes G40, G41, G42 (15.5.1, 15.5.3). call.row->arg is 0, 1, 2. The next motion in the plane starts or ends compensation; I, J, K
/// give the direction vector of this start or end.
Status radius_side(Emitter& m, const Call& call) {
  fanuc::UndoableState& state = fanuc_of(m).state;
  if (call.row->arg != 0 && m.modal.plane != Plane::xy && m.def.gives(AlarmId::compensation_plane))
    return fail(alarm(AlarmId::compensation_plane, call.where, call.row->code));
  if (call.row->arg != 0 && fanuc_of(m).settings.approach_own_block)  // start-up of type C (spec/fanuc 7.3)
    return fail(alarm(AlarmId::not_available, call.where, call.row->code + " (5003#1)"));
  const std::int8_t side = call.row->arg == 0 ? std::int8_t{0} : call.row->arg == 1 ? std::int8_t{-1} : std::int8_t{1};
  if (side != 0 && m.modal.radius_side == 0) state.side_step = SideStep::begins;
  else if (side == 0) state.side_step = state.compensates ? SideStep::ends : SideStep::none;
  if (m.has_code({Function::arc_cw, Function::arc_ccw}) || m.modal.motion == MotionMode::arc_cw || m.modal.motion == MotionMode::arc_ccw) {
    const bool line = m.has_code({Function::rapid, Function::linear});
    const bool moves = m.has_axis_words() && !line;
    if (moves && state.side_step == SideStep::ends) return fail(alarm(AlarmId::compensation_ends_in_arc, call.where));
    if (moves && state.side_step == SideStep::begins) return fail(alarm(AlarmId::compensation_begins_in_arc, call.where, call.row->code));
  }
  state.direction_vector.reset();
  if (const auto direction = fanuc::plane_direction(m)) state.direction_vector = *direction;
  m.modal.radius_side = side;
  if (state.side_step == SideStep::begins && fanuc_of(m).settings.compensation_check != state.compensation_check) {
    state.compensation_check = fanuc_of(m).settings.compensation_check;
    m.emit(state.compensation_check);
  }
  return {};
}

/// G38 (15.5.5): the compensation vector at the end of this block's line is the same as at the start of the line.
Status vector_hold(Emitter& m, const Call& call) {
  if (m.modal.radius_side == 0) return fail(alarm(AlarmId::compensation_needed, call.where, call.row->code));
  fanuc_of(m).holds_vector = true;
  return {};
}

/// G39 (15.5.6): adds an arc of the tool about the programmed point. The arc ends where the next motion starts. With I, J, K, the arc ends
/// where a motion in the direction I, J, K would start. The block must have no other motion.
Status vector_corner(Emitter& m, const Call& call) {
  if (m.modal.radius_side == 0) return fail(alarm(AlarmId::compensation_needed, call.where, call.row->code));
  if (m.has_axis_words()) return fail(alarm(AlarmId::own_block, call.where, call.row->code));
  m.emit(CompensationCorner{fanuc::plane_direction(m)});
  return {};
}

}  // namespace functions
}  // namespace kadr
