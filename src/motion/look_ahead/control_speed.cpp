// This file computes the speed limits that follow from the geometry of a path, within a block and at the junction of two blocks. Used by
// motion/look_ahead/look_ahead and motion/time/rapid_time.

#include "motion/look_ahead/control_speed.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/tolerance.h"
#include "path/curve/machine_path.h"

namespace kadr {
namespace {

/// Converts the vector `work` from work axis directions to machine axis directions and multiplies it by `factor`.
Axes along_machine(const Axes& work, double factor, const FrameTurn* turn) {
  Axes all = turned(turn, work);
  for (double& value : all) value *= factor;
  return all;
}

/// Returns the index of the machine axis that a programmed axis drives (nct 20.3).
std::size_t driven(std::size_t axis, const FrameTurn* turn) { return turn == nullptr ? axis : turn->drives.of(axis); }

Axes change(const Axes& from, const Axes& to) {
  Axes all{};
  for (std::size_t i = 0; i < max_axes; ++i) all[i] = to[i] - from[i];
  return all;
}

double size(const Axes& axes) {
  double sum = 0;
  for (const double value : axes) sum += value * value;
  return std::sqrt(sum);
}

/// Returns the angle between two directions in degrees. The computation is accurate for small angles too.
double turn_deg(const Axes& first, const Axes& second) {
  Axes one = first, other = second;
  const double one_size = size(first), other_size = size(second);
  for (std::size_t i = 0; i < max_axes; ++i) one[i] /= one_size, other[i] /= other_size;
  return 2 * std::asin(std::min(size(change(one, other)) / 2, 1.0)) / rad_per_deg;
}

/// Returns the greatest factor by which the vector `part` can be multiplied so that no component i exceeds most_i: the smallest quotient
/// most_i/|part_i|. Returns `unlimited` if the vector is zero.
double slowest(const Axes& most, const Axes& part) {
  double least = unlimited;
  for (std::size_t i = 0; i < max_axes; ++i)
    if (part[i] != 0) least = std::min(least, most[i] / std::abs(part[i]));
  return least;
}

/// Returns du/ds of an arc at the point `at`, in 1/mm; u is the direction of the path (PathShape). The vector du/ds points to the centre of
/// the arc. Its magnitude is in_plane²/r: r is the radius, and in_plane is the fraction of the path length s that lies in the arc's plane.
Axes bend(const Motion& m, const Axes& at, double in_plane, const FrameTurn* turn) {
  const Vec2 arm = m.center - Vec2{at[m.first], at[m.second]};
  Axes towards{};
  towards[m.first] = arm.x;
  towards[m.second] = arm.y;
  const double radius = std::max(length(arm), tol::least_radius);
  return along_machine(towards, in_plane * in_plane / (radius * radius), turn);
}

void widen(Axes& most, const Axes& u) {
  for (std::size_t i = 0; i < max_axes; ++i) most[i] = std::max(most[i], std::abs(u[i]));
}

void set_arc(PathShape& shape, const Motion& m, const Axes& from, double in_plane, const FrameTurn* turn) {
  const auto radius_at = [&](const Axes& at) { return length(Vec2{at[m.first], at[m.second]} - m.center); };
  // INFERRED (NCT 7.2): a spiral has two radii, at its start and its end. The smaller radius limits the speed.
  shape.radius = std::max(std::min(radius_at(from), radius_at(m.to)), tol::least_radius);
  shape.in_plane = in_plane;
  shape.start_bend = bend(m, from, in_plane, turn);
  shape.end_bend = bend(m, m.to, in_plane, turn);
  for (const std::size_t axis : {driven(m.first, turn), driven(m.second, turn)}) shape.most[axis] = std::max(shape.most[axis], in_plane);
}

/// Returns du/ds of a spline at the parameter `part`, 0 to 1, in 1/mm: the curvature vector, which is perpendicular to the path. The vector
/// points to the left of the path if the curvature is positive.
Axes bend_of_spline(const Motion& m, const Curve& curve, double part, double in_plane, const FrameTurn* turn) {
  const Axes rates = curve.rates(part);
  const double along = std::hypot(rates[m.first], rates[m.second]);
  Axes towards{};
  if (!(along > 0)) return towards;
  const double factor = curve.curvature(part) / along;
  towards[m.first] = -factor * rates[m.second];
  towards[m.second] = factor * rates[m.first];
  return along_machine(towards, in_plane * in_plane, turn);
}

/// Sets the curvature of a spline's shape. The spline is treated as an arc with the spline's smallest radius.
void set_spline(PathShape& shape, const Motion& m, const Curve& curve, double in_plane, const FrameTurn* turn) {
  const int places = curve.samples();
  double most = 0;
  for (int i = 0; i <= places; ++i) most = std::max(most, std::fabs(curve.curvature(static_cast<double>(i) / places)));
  if (!(most > 0)) return;
  shape.radius = std::max(1 / most, tol::least_radius);
  shape.in_plane = in_plane;
  shape.start_bend = bend_of_spline(m, curve, 0, in_plane, turn);
  shape.end_bend = bend_of_spline(m, curve, 1, in_plane, turn);
  for (const std::size_t axis : {driven(m.first, turn), driven(m.second, turn)}) shape.most[axis] = std::max(shape.most[axis], in_plane);
}

/// Returns the factor that reduces the feed while the tool is on the inside of an arc (NCT 6.4). INFERRED: the factor is 1 on the outside.
double inner_arc_part(const SpeedRules& rules, const Motion& m, const PathShape& shape) {
  const bool turns_left = m.kind == MotionKind::arc_ccw;
  const bool inside = m.tool_radius != 0 && m.side != 0 && (m.side * m.tool_radius > 0) == turns_left;
  if (!rules.slows_inner_arcs || !inside) return 1;
  return std::max(shape.radius / (shape.radius + std::abs(m.tool_radius)), rules.least_arc_part);
}

/// Returns the greatest feed on an arc, F = √(a·r), mm/s: r is the radius, and a is the smaller normal acceleration of the two axes of the
/// plane. The result is at least the parameter Circ F Min (NCT 7.2). INFERRED: for a helix only the motion in the plane counts.
double arc_speed(const SpeedRules& rules, const PathShape& shape) {
  double most = unlimited;
  for (std::size_t i = 0; i < max_axes; ++i)
    if ((shape.plane >> i & 1U) != 0) most = std::min(most, rules.normal[i]);
  return std::max(std::sqrt(most * shape.radius) / shape.in_plane, rules.least_arc_feed);
}

double corner_speed(const SpeedRules& rules, const PathShape& before, const PathShape& after) {
  if (rules.by_axis_change) return slowest(rules.axis_change, change(before.end, after.start));
  if (rules.corner_feed == unlimited) return unlimited;
  const double none = tol::tangential / rad_per_deg;
  return turn_deg(before.end, after.start) > rules.corner_angle + none ? rules.corner_feed : unlimited;
}

bool cuts_in_plane(const Motion& m, const PathShape& shape) {
  return m.side != 0 && (m.kind == MotionKind::feed || is_arc(m.kind)) && (shape.moves & ~shape.plane) == 0;
}

/// Sets the directions u of a path under tool centre point control. The path is sampled at the quarters of the motion and close to both of
/// its ends.
void set_with_tip_control(PathShape& shape, const MachinePath& path, std::size_t axes) {
  constexpr double near = 1.0 / 64;
  constexpr double parts[] = {0, near, 0.25, 0.5, 0.75, 1 - near, 1};
  Axes before = path.start();
  for (std::size_t k = 1; k < std::size(parts); ++k) {
    const Axes now = path.at(parts[k]);
    Axes u{};
    for (std::size_t i = 0; i < axes; ++i) u[i] = (now[i] - before[i]) / ((parts[k] - parts[k - 1]) * shape.length);
    widen(shape.most, u);
    if (k == 1) shape.start = u;
    shape.end = u;
    before = now;
  }
  shape.line = path.straight();
}

void set_along_curve(PathShape& shape, const Step& step, const Curve& curve) {
  const Motion& motion = *step.motion();
  const FrameTurn* const turn = step.from.turn.get();
  shape.line = curve.straight();
  const auto direction = [&](double part) { return along_machine(curve.rates(part), 1 / curve.rate(motion.along, part), turn); };
  shape.start = direction(0);
  widen(shape.most, shape.start);
  if (shape.line) shape.end = shape.start;
  else {
    shape.end = direction(1);
    widen(shape.most, shape.end);
    widen(shape.most, direction(0.5));
  }
  if (curve.straight() || curve.surface() != PathSurface::plane) return;
  const Axes rates = curve.rates(0.5);
  const double in_plane = std::hypot(rates[motion.first], rates[motion.second]) / curve.rate(motion.along, 0.5);
  if (curve.spline()) set_spline(shape, motion, curve, in_plane, turn);
  else set_arc(shape, motion, step.from.work, in_plane, turn);
}

}  // namespace

PathShape shape_of(const Step& step) {
  const Motion& motion = *step.motion();
  const Curve& curve = step.curve();
  PathShape shape;
  shape.length = curve.length(motion.along);
  const FrameTurn* const turn = step.from.turn.get();
  shape.plane = AxisMask{1} << driven(motion.first, turn) | AxisMask{1} << driven(motion.second, turn);
  if (controls_tip(step.from, motion)) set_with_tip_control(shape, MachinePath(step), step.roles.count);
  else set_along_curve(shape, step, curve);
  for (std::size_t i = 0; i < step.roles.count; ++i)
    if (shape.most[i] != 0) shape.moves |= AxisMask{1} << i;
  return shape;
}

Acceleration acceleration_of(const SpeedRules& rules, const PathShape& shape) {
  Acceleration path{slowest(rules.acceleration, shape.most), 0, rules.jerk_free};
  for (std::size_t i = 0; i < max_axes; ++i)
    if ((shape.moves >> i & 1U) != 0 && rules.acceleration[i] < unlimited) path.build_up = std::max(path.build_up, rules.build_up[i]);
  return path;
}

double block_speed(const SpeedRules& rules, const Motion& motion, const PathShape& shape, double commanded) {
  double speed = std::min(commanded, slowest(rules.max_feed, shape.most));
  if (shape.radius == 0) return speed;
  speed = std::min(speed, commanded * inner_arc_part(rules, motion, shape));
  return std::min(speed, arc_speed(rules, shape));
}

double junction_speed(const SpeedRules& rules, const PathShape& before, const PathShape& after) {
  const double corner = corner_speed(rules, before, after);
  if (before.radius == 0 && after.radius == 0) return corner;
  return std::min(corner, speed_in_bend(rules.arc_step, change(before.end_bend, after.start_bend)));
}

double blend_speed(const SpeedRules& rules, const PathShape& before, const PathShape& after, double tolerance) {
  const Axes turn = change(before.end, after.start);
  // At the path speed v the axes need the time t = by_speed · v to change the direction at the corner.
  const double by_speed = 1 / slowest(rules.acceleration, turn);
  if (size(turn) <= tol::tangential || !(by_speed > 0)) return unlimited;
  return std::sqrt(std::min(8 * tolerance / size(turn), std::min(before.length, after.length)) / by_speed);
}

Axes bend_between(const PathShape& before, const PathShape& after) {
  if (!before.line || !after.line) return {};
  Axes all = change(before.end, after.start);
  for (double& value : all) value *= 2 / (before.length + after.length);
  return all;
}

double speed_in_bend(const Axes& most, const Axes& bend) { return std::sqrt(slowest(most, bend)); }

double speed_over_step(const SpeedRules& rules, const Axes& bend, const Axes& next) {
  return speed_in_bend(rules.line_step, change(bend, next));
}

bool is_slow_corner(const SpeedRules& rules, const Motion& before, const PathShape& first, const Motion& after, const PathShape& second) {
  if (!(rules.inner_part < 1) || before.side != after.side) return false;
  if (!cuts_in_plane(before, first) || !cuts_in_plane(after, second) || first.plane != second.plane) return false;
  const Vec2 in{first.end[before.first], first.end[before.second]}, out{second.start[after.first], second.start[after.second]};
  // The change of the path's direction at the corner in degrees; counter-clockwise is positive.
  const double turn = std::atan2(cross(in, out), dot(in, out)) / rad_per_deg;
  const double side = before.side * (before.tool_radius < 0 ? -1 : 1);
  return turn * side > 0 && 180 - std::abs(turn) < rules.inner_angle;
}

}  // namespace kadr
