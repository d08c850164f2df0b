// This file has the geometry of a contour offset by the tool radius, in one plane: elements, the vectors at a junction of two elements, and
// compensated arcs. Used by the other folders of path; tested by tests/path/contour_offset_test.cpp.

#include "path/compensation/contour_offset.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"

namespace kadr {
namespace {

Vec2 unit(Vec2 v) { return 1 / length(v) * v; }

/// Returns true if the two tangents agree except for rounding errors: the angle between them is below a millionth of a radian (NCT 15.5.0;
/// the limit is INFERRED).
bool tangential(Vec2 a, Vec2 b) { return std::fabs(cross(a, b)) < tol::tangential && dot(a, b) > 0; }

Meetings none() { return {}; }

Meetings both(Vec2 first, Vec2 second) {
  Meetings m;
  m.add(first);
  m.add(second);
  return m;
}

Meetings of_lines(const OffsetElement& a, const OffsetElement& b) {
  const double c = cross(a.normal, b.normal);
  Meetings m;
  if (!(std::fabs(c) < tol::tangential))
    m.add(1 / c * Vec2{a.distance * b.normal.y - b.distance * a.normal.y, a.normal.x * b.distance - b.normal.x * a.distance});
  else if (dot(a.normal, b.normal) > 0 && std::fabs(a.distance - b.distance) <= tol::same_point) m.add(b.distance * b.normal);
  return m;
}

Meetings of_line_and_circle(const OffsetElement& line, const OffsetElement& circle, Vec2 point) {
  const Vec2 start = line.distance * line.normal, center = circle.center - point;
  const Vec2 foot = start + dot(center - start, line.tangent) * line.tangent;
  const double height = length(center - foot);
  if (circle.radius < 0 || height > circle.radius + tol::same_point) return none();
  const double half_chord = std::sqrt(std::max(circle.radius * circle.radius - height * height, 0.0));
  return both(foot - half_chord * line.tangent, foot + half_chord * line.tangent);
}

Meetings of_circles(const OffsetElement& a, const OffsetElement& b, Vec2 point) {
  const Vec2 between = b.center - a.center;
  const double d = length(between);
  if (a.radius < 0 || b.radius < 0 || d == 0) return none();
  if (d > a.radius + b.radius + tol::same_point || d < std::fabs(a.radius - b.radius) - tol::same_point) return none();
  const double along = (d * d + a.radius * a.radius - b.radius * b.radius) / (2 * d);
  const double height = std::sqrt(std::max(a.radius * a.radius - along * along, 0.0));
  const Vec2 u = 1 / d * between, foot = a.center - point + along * u;
  return both(foot + height * left_of(u), foot - height * left_of(u));
}

OffsetElement offset(const ContourElement& element, Vec2 tangent, double arc_radius, double radius, double side) {
  OffsetElement offset;
  offset.is_arc = element.is_arc;
  if (element.is_arc) {
    offset.center = element.center;
    offset.radius = arc_radius - side * element.sense() * radius;
    return offset;
  }
  offset.normal = side_normal(tangent, side);
  offset.distance = radius;
  offset.tangent = tangent;
  return offset;
}

/// The greatest distance of the intersection of the two offset lines from the corner, in tool radii. If the lines meet farther away, the
/// path reverses to within about a degree and has no corner (INFERRED).
constexpr double farthest_corner = 100;

/// Returns the vector to the intersection of the offset tangents whose normals are n1 and n2. The function is used at an outside corner of
/// at most 90°.
Vec2 of_tangents(Vec2 n1, Vec2 n2, double radius) { return radius / (1 + dot(n1, n2)) * (n1 + n2); }

}  // namespace

ContourElement ContourElement::line(Vec2 from, Vec2 to) {
  ContourElement e;
  e.from = from;
  e.to = to;
  e.start = e.end = unit(to - from);
  return e;
}

ContourElement ContourElement::arc(Vec2 from, Vec2 to, Vec2 center, double turns) {
  ContourElement e;
  e.from = from;
  e.to = to;
  e.is_arc = true;
  e.center = center;
  e.turns = turns;
  e.start_radius = length(from - center);
  e.end_radius = length(to - center);
  e.start = e.sense() / e.start_radius * left_of(from - center);
  e.end = e.sense() / e.end_radius * left_of(to - center);
  return e;
}

OffsetElement offset_at_end(const ContourElement& e, double radius, double side) { return offset(e, e.end, e.end_radius, radius, side); }
OffsetElement offset_at_start(const ContourElement& e, double radius, double side) {
  return offset(e, e.start, e.start_radius, radius, side);
}

std::optional<Vec2> intersection(const OffsetElement& first, const OffsetElement& second, Vec2 point) {
  const Meetings m = intersections(first, second, point);
  if (m.count == 0) return std::nullopt;
  return m.count == 1 || dot(m.at[0], m.at[0]) <= dot(m.at[1], m.at[1]) ? m.at[0] : m.at[1];
}

Meetings intersections(const OffsetElement& first, const OffsetElement& second, Vec2 point) {
  if (first.is_arc) return second.is_arc ? of_circles(first, second, point) : of_line_and_circle(second, first, point);
  return second.is_arc ? of_line_and_circle(first, second, point) : of_lines(first, second);
}

Corner corner_of(Vec2 t1, Vec2 t2, double side) {
  const double turn = side * cross(t1, t2);
  if (turn > 0 && !(turn < tol::tangential)) return Corner::inside;
  return dot(t1, t2) >= 0 ? Corner::obtuse : Corner::acute;
}

JunctionVectors without_short_steps(const JunctionVectors& vectors, double least) {
  JunctionVectors reduced = single(vectors.first());
  for (std::size_t i = 1; i < vectors.count; ++i) {
    const Vec2 step = vectors.at[i] - reduced.last();
    if (std::fabs(step.x) >= least || std::fabs(step.y) >= least) reduced.add(vectors.at[i]);
  }
  return reduced;
}

std::optional<JunctionVectors> junction(const ContourElement& first, const ContourElement& second, double radius, double side) {
  JunctionVectors v;
  const Vec2 t1 = first.end, t2 = second.start, n1 = side_normal(t1, side), n2 = side_normal(t2, side);
  if (tangential(t1, t2)) {
    v.add(radius * n2);
    return v;
  }
  switch (corner_of(t1, t2, side)) {
    case Corner::inside: {
      const auto meet = intersection(offset_at_end(first, radius, side), offset_at_start(second, radius, side), first.to);
      if (!meet) return std::nullopt;
      v.add(*meet);
      return v;
    }
    case Corner::obtuse:
      if (first.is_arc) v.add(radius * n1);
      v.add(of_tangents(n1, n2, radius));
      break;
    case Corner::acute:
      if (first.is_arc) v.add(radius * n1);
      v.add(radius * (n1 + t1));
      v.add(radius * (n2 - t2));
      break;
  }
  if (second.is_arc) v.add(radius * n2);
  return v;
}

std::optional<JunctionVectors> joined(const ContourElement& first, const ContourElement& second, double radius, double side,
                                      CornerJoin join) {
  const Vec2 n1 = side_normal(first.end, side), n2 = side_normal(second.start, side);
  if (join == CornerJoin::open) {
    JunctionVectors ends;
    ends.add(radius * n1);
    ends.add(radius * n2);
    return ends;
  }
  const bool outside = !tangential(first.end, second.start) && corner_of(first.end, second.start, side) != Corner::inside;
  if (!outside || join == CornerJoin::extended) return junction(first, second, radius, side);
  JunctionVectors v;
  if (join == CornerJoin::arc) {
    v.round = true;
    v.add(radius * n1);
    v.add(radius * n2);
    return v;
  }
  // The distance of the intersection from the corner is |n1 + n2| / (1 + n1 · n2) in tool radii, where n1 and n2 are the unit normals of
  // the offset lines.
  if ((1 + dot(n1, n2)) * farthest_corner * farthest_corner < 2) return std::nullopt;
  if (first.is_arc) v.add(radius * n1);
  v.add(of_tangents(n1, n2, radius));
  if (second.is_arc) v.add(radius * n2);
  return v;
}

std::optional<Vec2> entry_direction(Vec2 travel, double radius, double side) {
  const double distance = length(travel);
  if (!(distance > radius + tol::same_point)) return std::nullopt;
  const double across = side * radius / distance;  // sine of the angle between the tool's path and the line to the programmed point
  const double along = std::sqrt((1 - across) * (1 + across));
  const Vec2 ahead = 1 / distance * travel;
  return along * ahead + across * left_of(ahead);
}

std::optional<JunctionVectors> around_end(const ContourElement& first, const ContourElement& second, double radius, double side,
                                          CornerJoin join, bool approaches) {
  if (tangential(first.end, second.start) || corner_of(first.end, second.start, side) == Corner::inside) return std::nullopt;
  if (join != CornerJoin::arc) return joined(first, second, radius, side, join);
  JunctionVectors v;
  v.round = true;
  if (approaches) {
    const auto touching = entry_direction(first.to - first.from, radius, side);
    v.add(radius * side_normal(touching.value_or(first.end), side));
    v.add(radius * side_normal(second.start, side));
  } else {  // the departure backwards is an approach on the other side
    const auto touching = entry_direction(second.from - second.to, radius, -side);
    v.add(radius * side_normal(first.end, side));
    v.add(radius * side_normal(touching.value_or(-1.0 * second.start), -side));
  }
  return v;
}

bool fits(const ContourElement& element, Vec2 start_vector, Vec2 end_vector, double radius, double side) {
  if (!element.is_arc) return dot(element.to + end_vector - element.from - start_vector, element.start) >= -tol::same_point;
  const bool concave = side * element.sense() > 0;
  if (concave && std::min(element.start_radius, element.end_radius) <= radius + tol::same_point) return false;
  return compensated_turns(element, start_vector, end_vector) * element.sense() >= -tol::tangential;
}

JunctionVectors start_up(const ContourElement& first, const ContourElement& second, double radius, double side) {
  JunctionVectors v;
  const Vec2 t1 = first.end, t2 = second.start, n1 = side_normal(t1, side), n2 = side_normal(t2, side);
  const Corner corner = corner_of(t1, t2, side);
  if (corner == Corner::inside || tangential(t1, t2)) {
    v.add(radius * n2);
    return v;
  }
  v.add(radius * n1);
  if (corner == Corner::obtuse) {
    v.add(of_tangents(n1, n2, radius));
  } else {
    v.add(radius * (n1 + t1));
    v.add(radius * (n2 - t2));
  }
  if (second.is_arc) v.add(radius * n2);
  return v;
}

JunctionVectors cancel(const ContourElement& first, const ContourElement& second, double radius, double side) {
  JunctionVectors v;
  const Vec2 t1 = first.end, t2 = second.start, n1 = side_normal(t1, side), n2 = side_normal(t2, side);
  const Corner corner = corner_of(t1, t2, side);
  if (corner == Corner::inside || tangential(t1, t2)) {
    v.add(radius * n1);
    return v;
  }
  if (first.is_arc) v.add(radius * n1);
  if (corner == Corner::obtuse) {
    v.add(of_tangents(n1, n2, radius));
  } else {
    v.add(radius * (n1 + t1));
    v.add(radius * (n2 - t2));
  }
  v.add(radius * n2);
  return v;
}

bool is_on_offset(const ContourElement& e, Vec2 start_vector, Vec2 end_vector, double radius, double side) {
  // a tenth of tol::same_point, because results about a path are accurate to tol::same_point
  constexpr double tolerance = tol::same_point / 10;
  const Vec2 from = e.from + start_vector, to = e.to + end_vector;
  if (e.is_arc) {
    const double inside = side * e.sense() * radius, first = e.start_radius - inside, last = e.end_radius - inside;
    return first > 0 && last > 0 && std::fabs(length(from - e.center) - first) < tolerance &&
           std::fabs(length(to - e.center) - last) < tolerance;
  }
  const Vec2 n = side_normal(e.start, side);
  return std::fabs(dot(start_vector, n) - radius) < tolerance && std::fabs(dot(end_vector, n) - radius) < tolerance &&
         dot(to - from, e.start) >= 0;
}

bool gentle(const ContourElement& first, const ContourElement& second) {
  if (dot(first.end, second.start) < 0) return false;
  constexpr double quarter = 0.25;  // greatest change of direction at a corner that counts as gentle, in revolutions
  const double rest = tangential(first.end, second.start) ? 2 * quarter : quarter;
  return std::fabs(first.turns) + std::fabs(second.turns) <= rest;
}

double compensated_turns(const ContourElement& arc, Vec2 start_vector, Vec2 end_vector) {
  // returns the rotation of the direction from the centre, in revolutions, above −1/2 and at most 1/2
  const auto turned = [&](Vec2 at, Vec2 vector) {
    const Vec2 arm = at - arc.center;
    const double along = dot(arm, arm + vector), across = cross(arm, vector);
    constexpr double straight = 1e-8;  // Angle in radians. Below this value an angle and its tangent are equal in all digits.
    if (std::fabs(across) <= straight * along) return across / along / (2 * pi);
    return angle_deg({along, across}) / 360;
  };
  return arc.turns + turned(arc.to, end_vector) - turned(arc.from, start_vector);
}

}  // namespace kadr
