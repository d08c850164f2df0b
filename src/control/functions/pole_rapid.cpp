// G10 of GOST: rapid motion to a point in polar coordinates (spec/gost 6). The pole, its plane, the radius B and the angle A stay in force,
// so a block may have only B or only A (N11, N12 of the turning example in GOST 20999-83).

#include "control/functions/functions.h"

namespace kadr {
namespace {

constexpr std::size_t linear_axes = 3;  // X Y Z

bool has_axis(Plane plane, std::size_t axis) { return axes_of(plane).normal != axis; }

/// Returns the axes whose words in the block are coordinates of the pole, one bit per axis.
AxisMask pole_words(const BlockContext& m) {
  AxisMask words = 0;
  for (std::size_t a = 0; a < linear_axes; ++a)
    if (m.has(m.letters.axis_letter[a])) words |= 1u << a;
  return words;
}

/// Determines the plane of the pole from the axes that give its coordinates. Two axes define the plane: Z84 X0 is a turning plane, also in
/// G17. One axis keeps the plane in force if that plane contains the axis. INFERRED: Z alone in G17 means a turned workpiece. INFERRED:
/// without axis words the plane is that of the pole in force, or the plane of a G17, G18 or G19 programmed after the pole.
Plane plane_of_pole(const Modal& modal, AxisMask words) {
  constexpr AxisMask x = 1, y = 2, z = 4;
  if (words == (x | y | z)) return modal.plane;
  if (words == (x | y)) return Plane::xy;
  if (words == (z | x)) return Plane::zx;
  if (words == (y | z)) return Plane::yz;
  const bool chosen_again = modal.plane != modal.pole_under || !modal.polar_radius_given;
  const Plane plane = chosen_again ? modal.plane : modal.pole_plane;
  if (words == 0) return plane;
  const std::size_t axis = words == x ? 0 : words == y ? 1 : 2;
  for (const Plane known : {plane, modal.plane})
    if (has_axis(known, axis)) return known;
  return words == z ? Plane::zx : Plane::xy;
}

}  // namespace

/// Executes G10 of GOST. INFERRED: in G91 each word is added to the value in force, like an axis word.
Status functions::pole_rapid(Emitter& m, const Call& call) {
  Modal& modal = m.modal;
  modal.motion = MotionMode::rapid;
  modal.motion_row = static_cast<std::int16_t>(call.row - m.def.codes.data());
  const Modal before = modal;
  const AxisMask words = pole_words(m);
  const Plane plane = plane_of_pole(modal, words);
  const PlaneAxes axes = axes_of(plane);
  // The axis normal to the plane may not have a coordinate.
  if (const char third = m.letters.axis_letter[axes.normal]; (words >> axes.normal & 1u) != 0)
    return fail(alarm(AlarmId::word_unused, m.where(third), third));
  if (!m.has('B') && !m.has('A')) return fail(alarm(AlarmId::word_missing, call.where, 'B', call.row->code));
  if (!m.has('B') && !modal.polar_radius_given) return fail(alarm(AlarmId::word_missing, call.where, 'B', call.row->code));
  if (!m.has('A') && !modal.polar_angle_given) return fail(alarm(AlarmId::word_missing, call.where, 'A', call.row->code));
  const auto base = [&](double old) { return modal.absolute ? 0.0 : old; };
  for (std::size_t a = 0; a < linear_axes; ++a)
    if ((words >> a & 1u) != 0) {
      const double half = (modal.diameter >> a & 1u) != 0 ? 0.5 : 1;  // the word of a diameter axis is a diameter, so the value is halved
      modal.pole_of[a] = base(modal.pole_of[a]) + half * m.length_value(m.letters.axis_letter[a]);
    }
  if (m.has('B')) modal.polar_radius = base(modal.polar_radius) + m.length_value('B');
  if (m.has('A')) modal.polar_angle = base(modal.polar_angle) + m.value('A');
  modal.polar_radius_given = modal.polar_angle_given = true;
  modal.pole_plane = plane;
  modal.pole_under = modal.plane;
  const SinCos turn = sincos_deg(modal.polar_angle);
  Axes to = m.position.programmed;
  to[axes.first] = modal.pole_of[axes.first] + modal.polar_radius * turn.cos;
  to[axes.second] = modal.pole_of[axes.second] + modal.polar_radius * turn.sin;
  Status moved = m.straight(MotionKind::rapid, to, AxisMask{1} << axes.first | AxisMask{1} << axes.second);
  // If the motion fails, the modes are restored here, because an alarm restores only the position for such a block.
  if (!moved) modal = before;
  return moved;
}

}  // namespace kadr
