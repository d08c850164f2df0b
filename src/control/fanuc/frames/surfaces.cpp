// Polar and cylindrical interpolation: G12.1, G13.1, G7.1 (spec/nct/04 4.5, 4.6).

#include <cmath>

#include "base/code_literals.h"
#include "base/tolerance.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"

namespace kadr::fanuc {
namespace {

bool is_rotary(const BlockContext& m, std::size_t axis) { return (m.def.rotary >> axis & 1u) != 0; }

/// Converts a point of the virtual plane to positions of the linear and the rotary axis. Several angles that differ by full revolutions are
/// possible; the angle nearest to `near` (degrees) is used.
void to_polar(const BlockContext& m, const Axes& programmed, double near, Axes& work) {
  const PlaneAxes& plane = m.modal.axes;
  const double u = programmed[plane.first], w = programmed[plane.second];
  const double offset = fanuc_of(m).settings.axes[plane.second].polar_offset;
  const double side = m.modal.surface_side;
  const double r2 = u * u + w * w - offset * offset;
  const double r = r2 > 0 ? std::sqrt(r2) : 0;
  double angle = u == 0 && w == 0 ? near : angle_deg({side * u, side * w}) - (offset != 0 ? angle_deg({r, offset}) : 0);
  angle += 360 * std::round((near - angle) / 360);
  work[plane.first] = side * r;
  work[plane.second] = angle;
}

/// Converts a point on the cylinder to a point in mm on the unrolled surface.
Vec2 unrolled(const BlockContext& m, const Axes& point) {
  const PlaneAxes& plane = m.modal.axes;
  const auto flat = [&](std::size_t axis) { return is_rotary(m, axis) ? point[axis] * m.modal.surface_radius * rad_per_deg : point[axis]; };
  return {flat(plane.first), flat(plane.second)};
}

void set_surface(const BlockContext& m, MotionDetail& detail, const Axes& from, const Axes& to) {
  const PlaneAxes& plane = m.modal.axes;
  detail.surface = m.modal.surface;
  detail.radius = m.modal.surface_radius;
  detail.side = m.modal.surface_side;
  if (m.modal.surface == PathSurface::polar) {
    detail.flat_from = {from[plane.first], from[plane.second]};
    detail.flat_to = {to[plane.first], to[plane.second]};
    detail.offset = fanuc_of(m).settings.axes[plane.second].polar_offset;
    detail.max_rotary_speed = fanuc_of(m).settings.axes[plane.second].feed_most;
    detail.programmed = to;
    detail.has_programmed = true;
  } else {
    detail.flat_from = unrolled(m, from);
    detail.flat_to = unrolled(m, to);
  }
}

}  // namespace

Axes transformed(const BlockContext& m, const Axes& programmed) {
  return m.transform.identity ? programmed : m.transform.to_work(programmed);
}

Vec2 flat_point(const BlockContext& m, const Axes& point) {
  if (m.modal.surface == PathSurface::cylinder) return unrolled(m, point);
  return {point[m.modal.axes.first], point[m.modal.axes.second]};
}

/// Returns the positions of the real axes at a programmed end point. The point is transformed in the programmed plane first, and then, in
/// polar interpolation, converted to the linear and the rotary axis (4.5, INFERRED).
Axes surface_work(const BlockContext& m, const Axes& programmed) {
  const Axes point = transformed(m, programmed);
  return m.modal.surface == PathSurface::polar ? polar_work(m, point, fanuc_of(m).state.surface_angle) : point;
}

Axes polar_work(const BlockContext& m, const Axes& point, double near) {
  Axes work = point;
  to_polar(m, point, near, work);
  return work;
}

double swept_about_pole(const FlatArc& arc) {
  constexpr double pieces_of_turn = 64, max_sampled = 1000;
  const Vec2 arm = arc.from - arc.center;
  const double growth = length(arm) > 0 ? length(arc.to - arc.center) / length(arm) : 1;
  const double turns = std::fabs(arc.turns);
  double whole = 0;  // number of full revolutions of a circle with constant radius, whose swept angle is known without sampling points
  if (std::fabs(growth - 1) < tol::same_point) whole = std::floor(turns);
  const double around = length(arc.center) < length(arm) ? 360 : 0;
  const double left = std::min(turns - whole, max_sampled);
  const double sign = arc.turns < 0 ? -1 : 1;
  double swept = sign * whole * around;
  double angle = angle_deg(arc.from);
  const auto pieces = static_cast<int>(std::ceil(left * pieces_of_turn));
  for (int i = 1; i <= pieces; ++i) {
    const double part = static_cast<double>(i) / pieces;
    const Vec2 point = arc.center + (1 + (growth - 1) * part) * rotated(arm, sign * 360 * left * part);
    const double next = angle_deg(point);
    swept += next - angle - 360 * std::round((next - angle) / 360);
    angle = next;
  }
  return swept;
}

Axes before_transform(const BlockContext& m) {
  return m.modal.surface == PathSurface::polar ? transformed(m, m.position.programmed) : m.position.work;
}

void finish_surface(BlockContext& m, Motion& motion, const Axes& from) {
  set_surface(m, detail_of(m, motion), transformed(m, from), transformed(m, m.position.programmed));
  if (m.modal.surface == PathSurface::polar) detail_of(m, motion).programmed = m.position.programmed;
  motion.first = static_cast<std::uint8_t>(m.modal.axes.first);
  motion.second = static_cast<std::uint8_t>(m.modal.axes.second);
  if (m.modal.surface == PathSurface::polar) fanuc_of(m).state.surface_angle = m.position.work[m.modal.axes.second];
}

Status uncompensated_surface(const BlockContext& m) {
  if (m.modal.radius_side == 0 || fanuc_of(m).state.tool_radius == 0) return {};
  return fail(alarm(AlarmId::not_available, m.block->where, m.modal.radius_side < 0 ? "G41" : "G42"));
}

Status surface_line(Emitter& m, MotionKind kind, const Axes& programmed, AxisMask named) {
  const PlaneAxes& plane = m.modal.axes;
  const Axes from = m.position.programmed;
  const AxisMask both = 1u << plane.first | 1u << plane.second;
  const bool in_plane = (named & both) != 0;
  const bool polar = m.modal.surface == PathSurface::polar;
  // in G7.1 a rapid motion moves the real axes, so no path on the cylinder is added to the motion (4.6)
  const bool real_rapid = kind == MotionKind::rapid && !polar;
  if (polar && in_plane) {
    // The rotary axis follows the straight line continuously. Along a line it turns by at most half a revolution, so the nearer of two
    // possible angles is right.
    named |= both;
  }
  if (in_plane && !real_rapid) KADR_TRY(uncompensated_surface(m));
  m.move_to(programmed, surface_work(m, programmed), named);
  Motion& motion = m.add_motion(kind, named);
  if (kind != MotionKind::rapid && kind != MotionKind::home) m.set_feed(motion);
  if (in_plane && !real_rapid) finish_surface(m, motion, from);
  return {};
}

}  // namespace kadr::fanuc

namespace kadr::functions {

namespace {

Status allowed(const BlockContext& m, const Call& call) {
  if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, call.where, call.row->code));
  // Scaling or rotation raises an alarm: 4.5 and 4.6 do not state how they act while the axes of the plane have another meaning.
  if (m.transform.scaling || m.transform.turning)
    return fail(alarm(AlarmId::not_available, call.where, m.transform.scaling ? "G51" : "G68"));
  return {};
}

/// Selects the plane of a lathe's C axis for G12.1 (X and C) or G7.1 (C and Z), which a lathe needs not select by a code (spec/fanuc-t 11).
/// A channel without the axes keeps its plane, which the caller then refuses.
void select_surface_plane(BlockContext& m, Plane plane) {
  if (m.def.behaviour.lathe == Lathe::none) return;
  const int linear = fanuc::main_axis(m, plane == Plane::xy ? 1 : 3);
  int rotary = -1;
  for (std::size_t a = 0; a < m.axis_count && rotary < 0; ++a)
    if ((m.def.rotary >> a & 1U) != 0) rotary = static_cast<int>(a);
  if (linear < 0 || rotary < 0) return;
  const auto first = static_cast<std::size_t>(plane == Plane::xy ? linear : rotary);
  const auto second = static_cast<std::size_t>(plane == Plane::xy ? rotary : linear);
  m.modal.plane = plane;
  m.modal.axes = {first, second, m.modal.axes.normal};
}

/// Selects the plane of the code in force again, after the mode that has selected the plane of the C axis.
void select_plane_in_force(Emitter& m) {
  if (m.def.behaviour.lathe == Lathe::none) return;
  const std::uint8_t group = m.def.codes[static_cast<std::size_t>(m.def.row_of('G', 18_g))].group;
  const std::int16_t row = m.modal.rows[group];
  fanuc_of(m).plane_axes = 0;
  if (row >= 0) (void)select_plane(m, {&m.def.codes[static_cast<std::size_t>(row)], nullptr, {}});
}

}  // namespace

/// G12.1 (4.5): switches polar interpolation on. The plane must have a linear first axis and a rotary second axis. The rotary axis must be
/// at 0; the linear axis must not be at 0.
Status polar_surface_on(Emitter& m, const Call& call) {
  KADR_TRY(allowed(m, call));
  select_surface_plane(m, Plane::xy);
  const PlaneAxes& plane = m.modal.axes;
  const bool fits = (m.def.rotary >> plane.first & 1u) == 0 && (m.def.rotary >> plane.second & 1u) != 0;
  if (!fits) return fail(alarm(AlarmId::plane_illegal, call.where));
  const double linear = m.position.work[plane.first], rotary = m.position.work[plane.second];
  if (std::fabs(linear) <= tol::same_point)
    return fail(alarm(AlarmId::surface_start, call.where, std::string_view(m.axis_names[plane.first]), linear));
  if (std::fabs(rotary) > tol::same_angle)
    return fail(alarm(AlarmId::surface_start, call.where, std::string_view(m.axis_names[plane.second]), rotary));
  m.modal.surface = PathSurface::polar;
  m.modal.surface_side = linear > 0 ? 1 : -1;
  fanuc_of(m).state.surface_angle = rotary;
  Axes at = m.position.work;  // position of the tool in the virtual plane
  at[plane.second] = fanuc_of(m).settings.axes[plane.second].polar_offset;
  m.position.programmed = m.transform.to_programmed(at);
  return {};
}

Status polar_surface_off(Emitter& m, const Call& call) {
  KADR_TRY(allowed(m, call));
  if (m.modal.surface != PathSurface::polar) return {};
  m.modal.surface = PathSurface::plane;
  select_plane_in_force(m);
  const Axes before = m.position.work;
  fanuc::roll_positions(m, m.position.work);
  if (m.position.work != before) m.emit(m.frame_change());
  m.position.programmed = m.transform.to_programmed(m.position.work);
  return {};
}

/// G7.1 (4.6): A50 switches cylindrical interpolation on, for a cylinder of radius 50 about the axis A; A0 switches it off.
Status cylinder_mode(Emitter& m, const Call& call) {
  KADR_TRY(allowed(m, call));
  const PlaneAxes& plane = m.modal.axes;
  const Word* word = nullptr;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0 || (m.letters.axes & letter_bit(w.address)) == 0) continue;
    if ((m.def.rotary >> m.def.address(w.address).axis & 1u) == 0 || word != nullptr)
      return fail(alarm(AlarmId::illegal_address, w.where, w.written));
    word = &w;
  }
  if (word == nullptr) return fail(alarm(AlarmId::no_axis_word, call.where, call.row->code));
  const std::size_t axis = m.def.address(word->address).axis;
  const double radius = word->value * m.unit_scale();
  if (radius == 0) {
    m.modal.surface = PathSurface::plane;
    select_plane_in_force(m);
    return {};
  }
  select_surface_plane(m, Plane::yz);
  if (radius < 0) return fail(alarm(AlarmId::value_out_of_range, word->where, word->address, radius));
  if (axis != plane.first && axis != plane.second) return fail(alarm(AlarmId::plane_illegal, call.where));
  m.modal.surface = PathSurface::cylinder;
  m.modal.surface_radius = radius;
  return {};
}

}  // namespace kadr::functions
