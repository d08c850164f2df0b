// Functions for tool offsets, cutter compensation, work offsets, shifts, scale and rotation.

#include <cmath>

#include "base/tolerance.h"
#include "control/functions/cutter_compensation.h"
#include "control/functions/functions.h"

namespace kadr {
namespace {

/// Returns the value of the word with this letter as an offset number; `otherwise` if the block has no such word.
Result<std::uint32_t> offset_number(const BlockContext& m, char letter, std::uint32_t otherwise) {
  if (!m.has(letter)) return otherwise;
  return m.whole(letter, 0, m.def.behaviour.offsets);
}

/// G41, G42. On Mach3 (10.7.13) they are allowed only in the XY plane and only while compensation is off. The offset number is D, or the
/// number of the tool in the spindle; a word P replaces the radius of the table.
Status radius_comp(BlockContext& m, const Call& call, std::int8_t side) {
  if (m.def.behaviour.reads_arc_radius()) {
    if (m.modal.plane != Plane::xy) return fail(alarm(AlarmId::plane_wrong, call.where, call.row->code));
    if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, call.where, call.row->code));
    const auto number = offset_number(m, 'D', m.modal.tool < m.tables.offsets.size() ? m.modal.tool : 0);
    if (!number) return fail(number.error());
    m.modal.offset_number = *number;
    if (m.value('P') < 0) return fail(alarm(AlarmId::value_out_of_range, m.where('P'), 'P', m.value('P')));
    m.modal.radius_by_word = m.has('P') ? m.length_value('P') : -1;
  }
  return begin_compensation(m, call, side);
}

Status length(Emitter& m, const Call& call, std::int8_t sign) {
  m.modal.length_sign = sign;
  if ((call.row->takes & letter_bit('H')) != 0) {
    const auto number = offset_number(m, 'H', 0);
    if (!number) return fail(number.error());
    m.modal.length_number = *number;
    // Without H, Mach3 uses H0. On a control where T0404 also names a corrector (offset), the corrector in force applies (spec/gost 4).
    if (*number == 0 && !(m.def.behaviour.tool_and_corrector && !m.has('H'))) m.modal.length_sign = 0;
  }
  m.change_frames();
  return {};
}

/// Checks the rule of the 2С42 that the work offset may change only in a block with a straight motion, G90 and G40 (note to 6.4.1).
Status check_work_offset_change(const BlockContext& m, Span where) {
  if (!m.def.gives(AlarmId::zero_change)) return {};
  const bool in_force = m.modal.motion == MotionMode::rapid || m.modal.motion == MotionMode::linear;
  const bool arc_coded = m.has_code({Function::arc_cw, Function::arc_ccw});
  const bool straight = m.has_code({Function::rapid, Function::linear}) || (in_force && !arc_coded);
  if (straight && m.modal.absolute && m.modal.radius_side == 0) return {};
  return fail(alarm(AlarmId::zero_change, where));
}

/// Recomputes the tool's programmed coordinates after the transformation has changed; the tool does not move.
void transform_changed(BlockContext& m) {
  m.transform.refresh();
  m.position.programmed = m.transform.to_programmed(m.position.work);
}

/// Calls `use` for each axis word, with the axis and the word's value in mm or degrees. The value is as written, whether absolute or
/// incremental.
template <class Use>
void each_axis_word(const BlockContext& m, Use use) {
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    const char letter = m.letters.axis_letter[a];
    if (letter == 0 || !m.has(letter)) continue;
    const bool is_length = m.def.address(letter).unit == WordUnit::length;
    // The word X of a turning machine is a diameter, of which the value is halved (spec/gost 5).
    const double diameter = (m.modal.diameter >> a & 1u) != 0 ? 0.5 : 1.0;
    use(a, m.value(letter) * (is_length ? m.unit_scale() : 1.0) * diameter);
  }
}

void store_set_position(BlockContext& m) {
  const std::uint32_t first = m.variables.first(VariableKind::set_position);
  for (std::uint32_t a = 0; a < 6 && a < m.axis_count && first != 0; ++a) m.variables.set_raw(first + a, m.set_position[a]);
  (void)m.variables.consume_frames_changed();
}

/// Returns a + sign · b.
Axes sum(const Axes& a, const Axes& b, double sign) {
  Axes c;
  for (std::size_t i = 0; i < max_axes; ++i) c[i] = a[i] + sign * b[i];
  return c;
}

void set_axes(Axes& axes, AxisMask which, const Axes& values) {
  for (std::size_t a = 0; a < max_axes; ++a)
    if ((which >> a & 1u) != 0) axes[a] = values[a];
}

/// Reports words that this kind of data does not use, in a block with G10. L1 accepts X (spec/mach3 5), although a milling tool has no
/// offset along X.
Status data_words_used(Emitter& m, bool of_tool) {
  for (const char letter : {'X', 'Y', 'Z', 'A', 'B', 'C', 'R'}) {
    const bool used = of_tool ? letter == 'X' || letter == 'Z' || letter == 'R' : letter != 'R';
    if (m.has(letter) && !used) return fail(alarm(AlarmId::word_unused, m.where(letter), letter));
  }
  if (of_tool && m.has('X')) m.warn(warning(AlarmId::word_without_effect, m.where('X'), 'X', "G10 L1"));
  return {};
}

}  // namespace

namespace functions {

Status radius_comp_left(Emitter& m, const Call& call) { return radius_comp(m, call, -1); }
Status radius_comp_right(Emitter& m, const Call& call) { return radius_comp(m, call, +1); }
Status radius_comp_off(Emitter& m, const Call& call) { return end_contour(m, call); }

/// G40 of the 2С42: ends the radius compensation. If the block has a motion along Z, G40 ends the length compensation too (6.4.7; INFERRED
/// for blocks without Z).
Status compensation_off(Emitter& m, const Call& call) {
  KADR_TRY(end_contour(m, call));
  if (m.has('Z') && m.modal.length_sign != 0) {
    m.modal.length_sign = 0;
    for (std::size_t g = 1; g < m.def.groups.size(); ++g) {
      const std::int16_t row = m.modal.rows[g];
      if (row < 0) continue;
      const Function f = m.def.codes[static_cast<std::size_t>(row)].function;
      if (f == Function::length_plus || f == Function::length_minus) m.modal.rows[g] = -1;
    }
    m.change_frames();
  }
  return {};
}

Status length_plus(Emitter& m, const Call& call) { return length(m, call, +1); }
Status length_minus(Emitter& m, const Call& call) { return length(m, call, -1); }
Status length_off(Emitter& m, const Call&) {
  m.modal.length_sign = 0;
  m.modal.length_number = 0;
  m.change_frames();
  return {};
}

/// D of the 2С42 and GOST: puts the radius and the length of the offset with this number in force.
Status offset_word(Emitter& m, const Call&) {
  const auto number = m.whole('D', 0, m.def.behaviour.offsets);
  if (!number) return fail(number.error());
  m.modal.offset_number = *number;
  m.change_frames();
  return {};
}

Status work_zero(Emitter& m, const Call& call) {
  note_work_offset(m, static_cast<std::uint32_t>(call.row->arg));
  if (m.modal.work_zero == call.row->arg) return {};
  KADR_TRY(check_work_offset_change(m, call.where));
  m.modal.work_zero = static_cast<std::uint16_t>(call.row->arg);
  m.zero_shift = {};
  m.change_frames();
  return {};
}

/// G54–G59, and G59 P (Mach3 10.7.18): selects a fixture (work offset). Its number is the word P, or arg if there is no P.
Status fixture(Emitter& m, const Call& call) {
  if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, call.where, call.row->code));
  auto number = static_cast<std::uint32_t>(call.row->arg);
  if ((call.row->takes & letter_bit('P')) != 0 && m.has('P')) {
    const auto named = m.whole('P', 1, m.def.behaviour.fixtures);
    if (!named) return fail(named.error());
    number = *named;
  }
  m.modal.fixture = number;
  note_work_offset(m, number);
  if (const std::uint32_t variable = m.variables.first(VariableKind::fixture_number); variable != 0) m.variables.set_raw(variable, number);
  (void)m.variables.consume_frames_changed();
  m.change_frames();
  return {};
}

/// G92 of the 2С42's turning machines: A selects a permanent work offset; X and Z add a temporary work offset.
Status zero_shift(Emitter& m, const Call& call) {
  if (!m.has('A') && !m.has_axis_words()) return fail(alarm(AlarmId::no_axis_word, call.where, call.row->code));
  if (m.has('A')) {
    const auto number = m.whole('A', 1, 9);
    if (!number) return fail(number.error());
    m.modal.work_zero = static_cast<std::uint16_t>(*number);
    note_work_offset(m, *number);
    m.zero_shift = {};
  }
  each_axis_word(m, [&](std::size_t a, double v) { m.zero_shift[a] = v; });
  m.change_frames();
  return {};
}

/// G92 of GOST (turning example, N5): moves the origin by the values of the words, from the machine's origin M to the workpiece's origin W.
Status part_zero(Emitter& m, const Call& call) {
  if (!m.has_axis_words()) return fail(alarm(AlarmId::no_axis_word, call.where, call.row->code));
  each_axis_word(m, [&](std::size_t a, double v) { m.zero_shift[a] = v; });
  m.change_frames();
  return {};
}

/// G52 (Mach3 10.7.16): moves the origin of the work system by the values of the words. G52 and G92 store the shift in the same variable.
/// The values are scaled and rotated like other words: if the tool is at X4, its position after `G52 X7` is X-3.
Status temporary_shift(Emitter& m, const Call& call) {
  if (!m.has_axis_words()) return fail(alarm(AlarmId::no_axis_word, call.where, call.row->code));
  if (any_nonzero(m.set_position) && !m.set_position_by_g52) return fail(alarm(AlarmId::not_together, call.where, "G52", "G92"));
  const Axes zero = m.transform.to_work(Axes{});
  Axes amounts = m.transform.to_programmed(sum(m.set_position, zero, +1));
  AxisMask named = 0;
  each_axis_word(m, [&](std::size_t a, double v) { amounts[a] = v, named |= 1u << a; });
  const Axes shift = sum(m.transform.to_work(amounts), zero, -1);
  set_axes(m.set_position, m.transform.moved_with(named), shift);
  m.set_position_by_g52 = true;
  store_set_position(m);
  m.change_frames();
  return {};
}

/// G92 (Mach3 10.7.27): moves the origin so that the current point has the programmed coordinates of the words, with the rotation of G68
/// and the scale of G51 included. After G40 the current point is the tool's actual position.
Status set_position(Emitter& m, const Call& call) {
  if (!m.has_axis_words()) return fail(alarm(AlarmId::no_axis_word, call.where, call.row->code));
  if (any_nonzero(m.set_position) && m.set_position_by_g52) return fail(alarm(AlarmId::not_together, call.where, "G92", "G52"));
  if (compensates(m.modal)) return fail(alarm(AlarmId::compensation_active, call.where, call.row->code));
  restart_contour_at_tool(m);
  Axes reads = m.position.programmed;
  AxisMask named = 0;
  each_axis_word(m, [&](std::size_t a, double v) { reads[a] = v, named |= 1u << a; });
  const Axes here = sum(m.position.work, m.transform.to_work(reads), -1);
  set_axes(m.set_position, m.transform.moved_with(named), sum(m.set_position, here, +1));
  m.set_position_by_g52 = false;
  store_set_position(m);
  m.change_frames();
  return {};
}

Status set_position_reset(Emitter& m, const Call&) {
  m.set_position = {};
  m.set_position_by_g52 = false;
  store_set_position(m);
  m.change_frames();
  return {};
}

Status set_position_suspend(Emitter& m, const Call&) {
  m.set_position = {};
  m.set_position_by_g52 = false;
  m.change_frames();
  return {};
}

Status set_position_restore(Emitter& m, const Call&) {
  const std::uint32_t first = m.variables.first(VariableKind::set_position);
  for (std::uint32_t a = 0; a < 6 && a < m.axis_count && first != 0; ++a) m.set_position[a] = m.variables.raw(first + a);
  m.change_frames();
  return {};
}

/// G10 L1 P: writes a row of the tool table (Z: length, R: radius). G10 L2 P: writes the offsets of a fixture (RS274/NGC).
Status set_data(Emitter& m, const Call& call) {
  if (!m.has('L')) return fail(alarm(AlarmId::word_missing, call.where, 'L', call.row->code));
  const auto kind = m.whole('L', 1, 2);
  if (!kind) return fail(kind.error());
  if (!m.has('P')) return fail(alarm(AlarmId::word_missing, call.where, 'P', call.row->code));
  const auto number = m.whole('P', 1, *kind == 1 ? m.def.behaviour.offsets : m.def.behaviour.fixtures);
  if (!number) return fail(number.error());
  KADR_TRY(data_words_used(m, *kind == 1));
  if (*kind == 2) {
    const std::uint32_t first = m.variables.first(VariableKind::fixture, *number - 1);
    each_axis_word(m, [&](std::size_t a, double v) {
      if (a < 6) m.variables.set_raw(first + static_cast<std::uint32_t>(a), v);
    });
    (void)m.variables.consume_frames_changed();
  } else {
    ToolOffset& offset = m.tables.offsets[*number];
    m.journal.keep(m.tables.offsets[*number]);
    if (m.has('Z')) offset.length = m.length_value('Z');
    if (m.has('R')) offset.radius = m.length_value('R');
  }
  m.change_frames();
  return {};
}

/// G51 (Mach3 10.7.15): sets the scale factors of the axes that have a word; other axes keep their factors. I and J must equal the factors
/// of X and Y.
Status scale_on(Emitter& m, const Call& call) {
  if (!m.has_axis_words()) return fail(alarm(AlarmId::no_axis_word, call.where, call.row->code));
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    const char letter = m.letters.axis_letter[a];
    if (letter == 0 || !m.has(letter)) continue;
    if (m.value(letter) == 0) return fail(alarm(AlarmId::scale_zero, m.where(letter), letter));
    m.transform.scale[a] = m.value(letter);
  }
  for (const char letter : {'I', 'J'}) {
    const auto axis = static_cast<std::size_t>(letter - 'I');
    if (m.has(letter) && m.value(letter) != m.transform.scale[axis])
      return fail(alarm(AlarmId::value_out_of_range, m.where(letter), letter, m.value(letter)));
  }
  transform_changed(m);
  return {};
}

Status scale_off(Emitter& m, const Call&) {
  m.transform.scale.fill(1);
  transform_changed(m);
  return {};
}

/// G68 A B R I (Mach3 10.7.20): rotates by the angle R in degrees about the point (A, B). If the block has I, R is added to the angle in
/// force.
Status rotation_on(Emitter& m, const Call& call) {
  if (m.modal.plane != Plane::xy) return fail(alarm(AlarmId::plane_wrong, call.where, call.row->code));
  if (!m.has('R')) return fail(alarm(AlarmId::word_missing, call.where, 'R', call.row->code));
  if (m.has('A')) m.transform.rotation_center.x = m.length_value('A');
  if (m.has('B')) m.transform.rotation_center.y = m.length_value('B');
  m.transform.rotation = (m.has('I') ? m.transform.rotation : 0.0) + m.value('R');
  transform_changed(m);
  return {};
}

Status rotation_off(Emitter& m, const Call&) {
  m.transform.rotation = 0;
  transform_changed(m);
  return {};
}

/// G16 (Mach3 10.7.6): the current point becomes the pole.
Status polar_on(Emitter& m, const Call&) {
  restart_contour_at_tool(m);
  m.modal.polar = true;
  m.modal.pole = {m.position.programmed[0], m.position.programmed[1]};
  m.modal.polar_radius = m.modal.polar_angle = 0;
  return {};
}

Status polar_off(Emitter& m, const Call&) {
  m.modal.polar = false;
  return {};
}

}  // namespace functions
}  // namespace kadr
