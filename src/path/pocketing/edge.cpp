// This file has the geometry of one edge of a contour in a plane: a line, or an arc of at most half a circle. Used by out and path.

#include "path/pocketing/edge.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "path/curve/plane_distance.h"

namespace kadr::area {
namespace {

double swept_deg(const Edge& arc) { return 4 * std::atan(arc.bulge) / rad_per_deg; }

/// Returns the fraction of the arc's length at the angle of `p` about the centre. The fraction is 0 to 1 on the arc; it is not limited to
/// this range.
double part_of_angle(const Edge& arc, const Circle& c, Vec2 p) {
  const Vec2 a = arc.from - c.centre, b = p - c.centre;
  // angle of `p` from the start of the arc, degrees, above −180 and at most 180
  const double turn = std::atan2(cross(a, b), dot(a, b)) / rad_per_deg;
  const double sweep = swept_deg(arc);
  double part = turn / sweep;
  const double around = std::abs(360 / sweep);
  if (part < 0 && part + around < 1 + around / 2 && part + around - 1 < -part) part += around;
  return part;
}

/// Returns the fraction of the line's length at which the line is nearest to `p`. The fraction is not limited to 0 to 1.
double line_part(const Edge& e, Vec2 p) {
  const Vec2 delta = e.to - e.from;
  const double size = dot(delta, delta);
  return size > 0 ? dot(p - e.from, delta) / size : 0;
}

bool on_edge(const Edge& e, Vec2 p) { return distance(e, p) < tol::same_point; }

void add_meeting(std::vector<Vec2>& points, const Edge& a, const Edge& b, Vec2 p) {
  if (on_edge(a, p) && on_edge(b, p)) points.push_back(p);
}

void line_circle(std::vector<Vec2>& points, const Edge& a, const Edge& b, const Edge& line, const Circle& c) {
  const Vec2 delta = line.to - line.from;
  const Vec2 foot = line.from + line_part(line, c.centre) * delta;
  const double away = length(foot - c.centre);
  const double half = std::sqrt(std::max(0.0, (c.radius - away) * (c.radius + away)));
  const Vec2 unit = (1 / length(delta)) * delta;
  add_meeting(points, a, b, foot + half * unit);
  if (half > 0) add_meeting(points, a, b, foot - half * unit);
}

void circle_circle(std::vector<Vec2>& points, const Edge& a, const Edge& b) {
  const Circle p = circle_of(a), q = circle_of(b);
  const Vec2 delta = q.centre - p.centre;
  const double apart = length(delta);
  if (apart < tol::same_point) return;  // The circles are equal or concentric, so only the end points of the arcs can be common points.
  const double along = (apart * apart + (p.radius - q.radius) * (p.radius + q.radius)) / (2 * apart);
  const double half = std::sqrt(std::max(0.0, (p.radius - along) * (p.radius + along)));
  const Vec2 unit = (1 / apart) * delta, foot = p.centre + along * unit;
  add_meeting(points, a, b, foot + half * left_of(unit));
  if (half > 0) add_meeting(points, a, b, foot - half * left_of(unit));
}

/// Converts an edge to a PlanePiece, whose distances from other pieces can be measured.
PlanePiece piece_of(const Edge& e) {
  if (is_line(e)) return PlanePiece::of(ContourElement::line(e.from, e.to));
  return PlanePiece::of(ContourElement::arc(e.from, e.to, circle_of(e).centre, swept_deg(e) / 360));
}

}  // namespace

Circle circle_of(const Edge& arc) {
  const Vec2 delta = arc.to - arc.from;
  const Vec2 centre = 0.5 * (arc.from + arc.to) + ((1 - arc.bulge) * (1 + arc.bulge) / (4 * arc.bulge)) * left_of(delta);
  return {centre, length(delta) * (1 + arc.bulge * arc.bulge) / (4 * std::abs(arc.bulge))};
}

double length_of(const Edge& e) {
  const double chord = length(e.to - e.from);
  return is_line(e) ? chord : circle_of(e).radius * std::abs(4 * std::atan(e.bulge));
}

double length_of(const Edges& path) {
  double sum = 0;
  for (const Edge& e : path) sum += length_of(e);
  return sum;
}

Edge reversed(const Edge& e) { return {e.to, e.from, -e.bulge, e.open, e.line}; }

Edges reversed(const Edges& path) {
  Edges back;
  for (auto e = path.rbegin(); e != path.rend(); ++e) back.push_back(reversed(*e));
  return back;
}

Vec2 at(const Edge& e, double part) {
  if (part <= 0) return e.from;
  if (part >= 1) return e.to;
  if (is_line(e)) return e.from + part * (e.to - e.from);
  const Circle c = circle_of(e);
  return c.centre + kadr::rotated(e.from - c.centre, part * swept_deg(e));
}

Vec2 direction(const Edge& e, double part) {
  const Vec2 chord = e.to - e.from;
  const Vec2 unit = (1 / std::max(length(chord), tol::same_point)) * chord;
  return is_line(e) ? unit : kadr::rotated(unit, (part - 0.5) * swept_deg(e));
}

Edge section(const Edge& e, double from, double to) {
  Edge piece = e;
  piece.from = at(e, from);
  piece.to = at(e, to);
  if (!is_line(e)) piece.bulge = std::tan(std::atan(e.bulge) * (to - from));
  return piece;
}

double nearest_part(const Edge& e, Vec2 p) {
  if (is_line(e)) return std::clamp(line_part(e, p), 0.0, 1.0);
  const double part = part_of_angle(e, circle_of(e), p);
  if (part >= 0 && part <= 1) return part;
  return length(p - e.from) <= length(p - e.to) ? 0 : 1;
}

double distance(const Edge& e, Vec2 p) { return length(p - at(e, nearest_part(e, p))); }

double distance(const Edge& a, const Edge& b) { return kadr::distance(piece_of(a), piece_of(b)); }

std::vector<Vec2> meetings(const Edge& a, const Edge& b) {
  std::vector<Vec2> points;
  if (is_line(a) && is_line(b)) {
    const Vec2 u = a.to - a.from, v = b.to - b.from;
    const double across = cross(u, v);
    if (std::abs(across) > tol::tangential * length(u) * length(v))
      add_meeting(points, a, b, a.from + (cross(b.from - a.from, v) / across) * u);
  } else if (is_line(a)) line_circle(points, a, b, a, circle_of(b));
  else if (is_line(b)) line_circle(points, a, b, b, circle_of(a));
  else circle_circle(points, a, b);
  for (const Vec2 p : {a.from, a.to})
    if (on_edge(b, p)) points.push_back(p);
  for (const Vec2 p : {b.from, b.to})
    if (on_edge(a, p)) points.push_back(p);
  return points;
}

void Bounds::take(Vec2 p) {
  least = {std::min(least.x, p.x), std::min(least.y, p.y)};
  most = {std::max(most.x, p.x), std::max(most.y, p.y)};
}

void Bounds::take(const Edge& e) {
  const Box2 box = piece_of(e).box;
  take(box.least);
  take(box.most);
}

bool Bounds::near(const Bounds& other, double reach) const {
  return least.x - reach <= other.most.x && other.least.x - reach <= most.x && least.y - reach <= other.most.y &&
         other.least.y - reach <= most.y;
}

Bounds bounds_of(const Edges& path) {
  Bounds box;
  for (const Edge& e : path) box.take(e);
  return box;
}

Edge rotated(const Edge& e, double deg) { return {kadr::rotated(e.from, deg), kadr::rotated(e.to, deg), e.bulge, e.open, e.line}; }

Edges tangent_arc(Vec2 from, Vec2 tangent, Vec2 to) {
  const Vec2 chord = to - from;
  const double half = std::atan2(cross(tangent, chord), dot(tangent, chord));  // half of the swept angle of the arc, rad
  if (std::abs(half) < tol::tangential) return {{from, to}};
  if (std::abs(half) <= pi / 2) return {{from, to, std::tan(half / 2)}};
  const Vec2 middle = 0.5 * (from + to) + (std::tan(half / 2) / 2) * Vec2{chord.y, -chord.x};
  return {{from, middle, std::tan(half / 4)}, {middle, to, std::tan(half / 4)}};
}

}  // namespace kadr::area
