// This file computes the corner between two contour elements: its position, and the chamfer or rounding at the corner. Used by
// path/compensation/corner_resolver and path/compensation/contour_motion; tested by tests/path/corner_geometry_test.cpp.

#include "path/curve/corner_geometry.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"

namespace kadr {
namespace {

/// Returns the supporting curve as an offset element with offset 0, relative to `point`.
OffsetElement seen_from(const Support& s, Vec2 point) {
  OffsetElement e;
  e.is_arc = s.is_circle;
  e.center = s.center;
  e.radius = s.radius;
  if (s.is_circle) return e;
  e.tangent = s.direction;
  e.normal = left_of(s.direction);
  e.distance = dot(s.point - point, e.normal);
  return e;
}

/// Returns true if the second intersection comes before the first intersection, clockwise on the circle from the start of the circle's
/// element (INFERRED, NCT 17.3.4).
bool second_comes_first(const Support& circle, const Meetings& meet, bool mirrored) {
  const Vec2 start = circle.point - circle.center;
  const double sense = mirrored ? 1 : -1;
  const auto turns = [&](Vec2 vector) { return swept_turns(start, circle.point + vector - circle.center, sense); };
  return turns(meet.at[1]) < turns(meet.at[0]);
}

double radius_at(const ContourElement& e, Vec2 corner) { return length(corner - e.center); }

/// The point of an element at a given chord length from the corner, and the travel between the corner and that point. If `back` is −1, the
/// point is before the corner, at the end of the element.
struct Touch {
  Vec2 point;
  double travel = 0;
};
std::optional<Touch> at_chord(const ContourElement& e, Vec2 corner, Vec2 tangent, double chord, double back) {
  if (!e.is_arc) return Touch{corner + back * chord * tangent, chord};
  const double radius = radius_at(e, corner);
  if (!(chord <= 2 * radius)) return std::nullopt;
  const double angle = 2 * std::asin(chord / (2 * radius)) / rad_per_deg;
  return Touch{e.center + rotated(corner - e.center, back * e.sense() * angle), angle / 360};
}

/// Returns the point at which an arc about `center` is tangent to an element.
Vec2 touch_point(const ContourElement& e, Vec2 corner, Vec2 tangent, Vec2 center) {
  if (!e.is_arc) return corner + dot(center - corner, tangent) * tangent;
  const Vec2 arm = center - e.center;
  return e.center + radius_at(e, corner) / length(arm) * arm;
}

/// Returns the travel along an element from one point to another point. The result is 0 if the travel is negative because of rounding
/// errors only.
double travel_between(const ContourElement& e, Vec2 from, Vec2 to, Vec2 tangent) {
  if (!e.is_arc) return dot(to - from, tangent);
  const double turns = swept_turns(from - e.center, to - e.center, e.sense());
  return 1 - turns <= slack(e) ? 0 : turns;
}

bool has_room(double travel, double room, double tolerance) { return travel >= -tolerance && travel <= room + tolerance; }

}  // namespace

double swept_turns(Vec2 from, Vec2 to, double sense) {
  const double turns = sense * angle_deg({dot(from, to), cross(from, to)}) / 360;
  return turns < 0 ? turns + 1 : turns;
}

double whole_travel(const ContourElement& e) { return e.is_arc ? std::fabs(e.turns) : length(e.to - e.from); }
double slack(const ContourElement& e) {
  return e.is_arc ? tol::same_point / (2 * pi * std::max(e.start_radius, e.end_radius)) : tol::same_point;
}

bool meet_smoothly(const ContourElement& first, const ContourElement& second) {
  return std::fabs(cross(first.end, second.start)) < tol::tangential && dot(first.end, second.start) > 0;
}

std::optional<Vec2> calculated_corner(const Support& first, const Support& second, CornerChoice choice) {
  const bool lines = !first.is_circle && !second.is_circle;
  if (lines && std::fabs(cross(first.direction, second.direction)) < tol::tangential) return std::nullopt;
  const Meetings meet = intersections(seen_from(first, first.point), seen_from(second, first.point), first.point);
  if (meet.count == 0) return std::nullopt;
  if (lines) return first.point + meet.at[0];
  const bool circles = first.is_circle && second.is_circle;
  const bool exchanged = circles && second_comes_first(first, meet, choice.mirrored);
  return first.point + meet.at[choice.farther != exchanged ? 1 : 0];
}

std::optional<CornerElement> chamfer(const ContourElement& first, const ContourElement& second, double leg) {
  const auto begin = at_chord(first, first.to, first.end, leg, -1);
  const auto end = at_chord(second, second.from, second.start, leg, 1);
  if (!begin || !end) return std::nullopt;
  CornerElement c;
  c.from = begin->point;
  c.to = end->point;
  c.first_travel = begin->travel;
  c.second_travel = end->travel;
  return c;
}

std::optional<CornerElement> rounding(const ContourElement& first, const ContourElement& second, double radius, CornerRoom room) {
  const double turn = cross(first.end, second.start), side = turn > 0 ? 1 : -1;
  if (!(std::fabs(turn) >= tol::tangential)) return std::nullopt;  // The second element goes back along the first element, so no arc fits.
  const Vec2 corner = first.to;
  const OffsetElement before = offset_at_end(first, radius, side), after = offset_at_start(second, radius, side);
  for (const OffsetElement& e : {before, after})
    if (e.is_arc && !(e.radius > tol::same_point)) return std::nullopt;
  const Meetings meet = intersections(before, after, corner);
  std::optional<CornerElement> best;
  double best_distance = 0;
  for (std::size_t i = 0; i < meet.count; ++i) {
    CornerElement c;
    c.center = corner + meet.at[i];
    c.from = touch_point(first, corner, first.end, c.center);
    c.to = touch_point(second, corner, second.start, c.center);
    c.first_travel = travel_between(first, c.from, corner, first.end);
    c.second_travel = travel_between(second, corner, c.to, second.start);
    c.turns = side * swept_turns(c.from - c.center, c.to - c.center, side);
    const double distance = length(meet.at[i]);
    if (!has_room(c.first_travel, room.first, slack(first)) || !has_room(c.second_travel, room.second, slack(second))) continue;
    if (best && best_distance <= distance) continue;
    best = c;
    best_distance = distance;
  }
  return best;
}

}  // namespace kadr
