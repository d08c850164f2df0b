// This file computes the distance between two pieces of a path in a plane. A piece is a line or an arc. Used by the other folders of path.

#include "path/curve/plane_distance.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

/// Returns true if an arc crosses the ray from its centre in the direction of `arm`.
bool passes(const PlanePiece& arc, Vec2 arm) {
  if (std::fabs(arc.turns) >= 1) return true;
  const Vec2 first = (arc.turns > 0 ? arc.from : arc.to) - arc.center, last = (arc.turns > 0 ? arc.to : arc.from) - arc.center;
  const bool after = cross(first, arm) >= 0, before = cross(arm, last) >= 0;
  return std::fabs(arc.turns) <= 0.5 ? after && before : after || before;
}

double from_point(Vec2 p, const PlanePiece& piece) {
  if (piece.is_arc) {
    const Vec2 arm = p - piece.center;
    if (passes(piece, arm)) return std::fabs(length(arm) - piece.radius);
    return std::min(length(p - piece.from), length(p - piece.to));
  }
  const Vec2 delta = piece.to - piece.from;
  const double square = dot(delta, delta);
  const double part = square > 0 ? std::clamp(dot(p - piece.from, delta) / square, 0.0, 1.0) : 0.0;
  return length(p - piece.from - part * delta);
}

bool lines_cross(const PlanePiece& a, const PlanePiece& b) {
  const Vec2 u = a.to - a.from, v = b.to - b.from;
  const double a0 = cross(u, b.from - a.from), a1 = cross(u, b.to - a.from), b0 = cross(v, a.from - b.from), b1 = cross(v, a.to - b.from);
  return ((a0 < 0) != (a1 < 0)) && ((b0 < 0) != (b1 < 0));
}

/// Returns the distance between a line and an arc without regard to their ends. The distance is 0 if they cross; otherwise it is measured
/// at the foot of the perpendicular from the arc's centre to the line. The result is HUGE_VAL if this foot is not on both the line and the
/// arc.
double inner_line_arc(const PlanePiece& line, const PlanePiece& arc) {
  constexpr double none = HUGE_VAL;
  const Vec2 delta = line.to - line.from;
  const double square = dot(delta, delta);
  if (square == 0) return none;
  const double part = dot(arc.center - line.from, delta) / square;
  const Vec2 foot = line.from + part * delta;
  const double height = length(foot - arc.center);
  if (height > arc.radius) return part >= 0 && part <= 1 && passes(arc, foot - arc.center) ? height - arc.radius : none;
  const double half = std::sqrt((arc.radius * arc.radius - height * height) / square);
  for (const double at : {part - half, part + half})
    if (at >= 0 && at <= 1 && passes(arc, line.from + at * delta - arc.center)) return 0;
  return none;
}

/// Returns the distance between two arcs without regard to their ends. The distance is 0 if the arcs cross; otherwise it is measured on the
/// line through their centres.
double inner_arcs(const PlanePiece& a, const PlanePiece& b) {
  double least = HUGE_VAL;
  const Vec2 between = b.center - a.center;
  const double d = length(between);
  if (d == 0) return least;  // For concentric arcs the distances at their end points are sufficient, so no further distance is returned.
  const Vec2 u = 1 / d * between;
  for (const double i : {-1.0, 1.0})
    for (const double j : {-1.0, 1.0})
      if (passes(a, i * u) && passes(b, j * u)) least = std::min(least, std::fabs(d + j * b.radius - i * a.radius));
  if (d > a.radius + b.radius || d < std::fabs(a.radius - b.radius)) return least;
  const double along = (d * d + a.radius * a.radius - b.radius * b.radius) / (2 * d);
  const double height = std::sqrt(std::max(a.radius * a.radius - along * along, 0.0));
  for (const double side : {-1.0, 1.0}) {
    const Vec2 arm = along * u + side * height * left_of(u);
    if (passes(a, arm) && passes(b, arm - between)) return 0;
  }
  return least;
}

}  // namespace

PlanePiece PlanePiece::line(Vec2 from, Vec2 to) {
  PlanePiece piece;
  piece.from = piece.box.least = piece.box.most = from;
  piece.to = to;
  piece.box.take(to);
  return piece;
}

PlanePiece PlanePiece::arc(Vec2 from, Vec2 to, Vec2 center, double turns) {
  PlanePiece piece = line(from, to);
  const Vec2 start = from - center, end = to - center;
  const double start_radius = length(start), end_radius = length(end);
  piece.is_arc = true;
  piece.center = center;
  piece.turns = turns;
  piece.radius = (start_radius + end_radius) / 2;
  piece.slack = std::fabs(start_radius - end_radius);
  take_quarters(piece.box, {center, piece.radius, turns > 0 ? start : end, turns > 0 ? end : start, std::fabs(turns)});
  return piece;
}

double distance(const PlanePiece& a, const PlanePiece& b) {
  const double ends = std::min({from_point(a.from, b), from_point(a.to, b), from_point(b.from, a), from_point(b.to, a)});
  if (a.is_arc && b.is_arc) return std::min(ends, inner_arcs(a, b));
  if (a.is_arc) return std::min(ends, inner_line_arc(b, a));
  if (b.is_arc) return std::min(ends, inner_line_arc(a, b));
  return lines_cross(a, b) ? 0 : ends;
}

}  // namespace kadr
