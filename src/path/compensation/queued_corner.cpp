// This file computes the corners of a contour as LinuxCNC does. It uses LinuxCNC's formulas in their original order, so that borderline
// cases give the same result. Used by path/compensation/queued_compensation; tested by tests/path/queued_compensation_test.cpp.

#include "path/compensation/queued_corner.h"

#include <cmath>

namespace kadr {
namespace {

constexpr double half_turn = pi, quarter_turn = pi / 2;
constexpr double small_angle = 0.05;  // tolerance, rad, for the comparison of corner angles: TOLERANCE_CONCAVE_CORNER of LinuxCNC's source
constexpr double least_entry_cos = 0.0001;  // TOLERANCE_EQUAL of LinuxCNC's source

double angle_of(Vec2 v) { return std::atan2(v.y, v.x); }
Vec2 at_angle(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }
bool off_sine(double l) { return l > 1.0 || l < -1.0; }
double apart_by(Vec2 a, Vec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// True if the tool is on the outer side of an arc that ends at the next line. The tool must then not move around the end of the arc.
/// LinuxCNC's source calls these shapes "h" and "m".
bool comes_over_arc(const CornerSituation& p, double beta) {
  return beta > half_turn - small_angle && p.held && p.arc && (p.side > 0 ? p.arc->turn < 0 : p.arc->turn > 0);
}

/// Returns the point at which the tool's path along the previous arc meets the tool's path along the line.
Result<Vec2> arc_meets_line(const CornerSituation& p, Vec2 to) {
  const QueuedArc& before = *p.arc;
  const double radius = apart_by(before.center, before.end);
  const double along = angle_of(to - p.point);
  const double normal = before.turn > 0 ? along + quarter_turn : along - quarter_turn;
  const bool inside = inside_arc(p.side, before.turn);
  const double programmed = inside ? radius + p.radius : radius - p.radius;
  // distance of the arc's centre from the line, mm
  const double across = programmed * std::cos(normal - angle_of(before.center - p.point));
  const double l = (inside ? across - p.radius : across + p.radius) / radius;
  if (off_sine(l)) return fail(alarm(AlarmId::gouge_arc_to_line, {}));
  const bool back = inside == (before.turn > 0);
  return before.center + at_angle(radius, (back ? -std::acos(l) : std::acos(l)) + normal + half_turn);
}

/// Returns the point at which the tool's path along the previous line meets the tool's path along the arc. `theta` is the direction of the
/// previous line in rad.
Result<Vec2> line_meets_arc(const CornerSituation& p, const QueuedArc& arc, double arc_radius, double theta, double beta) {
  const double across = arc_radius * std::sin(beta - quarter_turn);
  const bool inside = inside_arc(p.side, arc.turn);
  const double from_center = inside ? arc_radius - p.radius : arc_radius + p.radius;
  const double l = (inside ? across + p.radius : across - p.radius) / from_center;
  if (off_sine(l)) return fail(alarm(AlarmId::gouge_arc, {}));
  const double angle = inside ? theta : theta + half_turn;
  const bool adds = inside == (arc.turn > 0);
  return arc.center + at_angle(from_center, adds ? angle + std::asin(l) : angle - std::asin(l));
}

/// Returns the point at which the tool's path along the previous arc meets the tool's path along the next arc.
Result<Vec2> arc_meets_arc(const CornerSituation& p, const QueuedArc& arc, double arc_radius) {
  const QueuedArc& before = *p.arc;
  const double first = apart_by(before.center, before.end);
  const double second = inside_arc(p.side, arc.turn) ? arc_radius - p.radius : arc_radius + p.radius;
  const double apart = apart_by(before.center, arc.center);
  if (first == 0 || apart == 0) return fail(alarm(AlarmId::arcs_same_center, {}));
  const double a = (first * first + apart * apart - second * second) / (2 * first * apart);
  if (off_sine(a)) return fail(alarm(AlarmId::gouge_arc_to_arc, {}));
  const double to_other = angle_of(arc.center - before.center), pull = std::acos(a);
  const bool adds = inside_arc(p.side, before.turn) == (arc.turn > 0);
  return before.center + at_angle(first, adds ? to_other + pull : to_other - pull);
}

}  // namespace

double swept_by(Vec2 from, Vec2 center, int turn, Vec2 to) {
  if (turn == 0) return 0;
  double begin = angle_of(from - center), end = angle_of(to - center);
  if (turn > 0) {
    if (end <= begin) end += 2 * pi;
    return (end - begin) + (turn - 1) * (2 * pi);
  }
  if (begin <= end) begin += 2 * pi;
  return (end - begin) + (turn + 1) * (2 * pi);
}

Result<QueuedCorner> corner_to_line(const CornerSituation& p, Vec2 to) {
  const bool left = p.side > 0;
  const double across = left ? quarter_turn : -quarter_turn;
  double theta = angle_of(p.tool - p.point), alpha = angle_of(to - p.point);
  if (left && theta < alpha) theta += 2 * pi;
  if (!left && alpha < theta) alpha += 2 * pi;
  const double beta = (left ? theta - alpha : alpha - theta) - quarter_turn;
  const Vec2 normal = at_angle(p.radius, alpha + across);
  const bool inner = beta < -small_angle || beta > half_turn + small_angle || comes_over_arc(p, beta);
  if (!inner) return QueuedCorner{beta > small_angle ? CornerKind::outer : CornerKind::straight, p.point + normal, to + normal};
  if (p.arc) {
    const auto meet = arc_meets_line(p, to);
    if (!meet) return fail(meet.error());
    return QueuedCorner{CornerKind::inner, *meet, to + normal};
  }
  // The divisor (the tangent) is never 0, because the gouge checks detect a reversal of the path.
  const double retreat = p.radius / std::tan((beta + half_turn) / 2);
  return QueuedCorner{CornerKind::inner, p.tool + at_angle(retreat, theta + across), to + normal};
}

Result<QueuedCorner> corner_to_arc(const CornerSituation& p, const QueuedArc& arc) {
  const bool left = p.side > 0, inside = inside_arc(p.side, arc.turn);
  const double arc_radius = apart_by(arc.center, arc.end);
  double theta = angle_of(p.tool - p.point);
  theta = left ? theta - quarter_turn : theta + quarter_turn;
  double delta = angle_of(arc.center - p.point);
  const double alpha = arc.turn > 0 ? delta - quarter_turn : delta + quarter_turn;
  double beta = left ? theta - alpha : alpha - theta;
  beta = beta > 1.5 * pi ? beta - 2 * pi : beta < -quarter_turn ? beta + 2 * pi : beta;
  if (inside && arc_radius <= p.radius) return fail(alarm(AlarmId::arc_within_tool, {}));
  if (!inside) delta += half_turn;
  const Vec2 end = arc.end + at_angle(p.radius, angle_of(inside ? arc.center - arc.end : arc.end - arc.center));
  const bool over_arc = std::fabs(beta - half_turn) < small_angle && !inside;
  if (beta < -small_angle || beta > half_turn + small_angle || over_arc) {
    const auto meet = p.arc ? arc_meets_arc(p, arc, arc_radius) : line_meets_arc(p, arc, arc_radius, theta, beta);
    if (!meet) return fail(meet.error());
    return QueuedCorner{CornerKind::inner, *meet, end};
  }
  return QueuedCorner{beta > small_angle ? CornerKind::outer : CornerKind::straight, p.point + at_angle(p.radius, delta), end};
}

Result<QueuedArc> entry_arc(Vec2 from, const QueuedArc& arc, double radius, double side) {
  if (apart_by(arc.end, from) <= radius) return fail(alarm(AlarmId::entry_arc_within_tool, {}));
  const bool inside = inside_arc(side, arc.turn);
  if (inside && apart_by(arc.center, from) <= radius) return fail(alarm(AlarmId::arc_within_tool, {}));
  const Vec2 end = arc.end + at_angle(radius, angle_of(inside ? arc.center - arc.end : arc.end - arc.center));
  // The centre of the entry arc lies on the line from `end` to the programmed centre. Its distances from the start and the end of the arc
  // are equal.
  const double to_center = angle_of(arc.center - end), at_end = angle_of(from - end) - to_center;
  if (std::fabs(std::cos(at_end)) < least_entry_cos) return fail(alarm(AlarmId::arc_within_tool, {}));
  return QueuedArc{end, end + at_angle(apart_by(from, end) / 2 / std::cos(at_end), to_center), arc.turn};
}

}  // namespace kadr
