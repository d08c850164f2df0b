// Computes the areas that tools sweep in the half plane of a spinning part. Tested by tests/stock/turned_stock_test.cpp.

#include "stock/turned/insert_sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kadr {
namespace {

constexpr double same_point = 1e-9;  // mm; points that are closer count as the same point
constexpr double full_turn = 2 * std::numbers::pi, quarter_turn = std::numbers::pi / 2;

Vec2 vec_of(const InsertPoint& p) { return {p.x, p.z}; }
double angle_of(const InsertPoint& n) { return std::atan2(n.z, n.x); }

/// Returns the unit vector in a direction, rad; exact along the axes.
Vec2 unit(double angle) {
  const double quarters = angle / quarter_turn, whole = std::round(quarters);
  if (std::fabs(quarters - whole) > 1e-12) return {std::cos(angle), std::sin(angle)};
  const int q = int(whole) & 3;
  return q == 0 ? Vec2{1, 0} : q == 1 ? Vec2{0, 1} : q == 2 ? Vec2{-1, 0} : Vec2{0, -1};
}

void add_point(TurnedPolygon& outline, Vec2 p) {
  if (outline.empty() || length(outline.back() - p) > same_point) outline.push_back(p);
}

/// Appends the arc of a corner from one direction of the outward normal to another, rad. The points at the axes' directions are exact: the
/// imaginary tip is measured there.
void add_arc(TurnedPolygon& outline, const InsertCorner& corner, double from, double to, double chord) {
  const double step = 2 * std::acos(std::max(0.5, 1 - chord / corner.radius));
  const auto add = [&](double angle) { add_point(outline, vec_of(corner.centre) + corner.radius * unit(angle)); };
  double at = from;
  add(at);
  while (at < to) {
    const double axis = (std::floor(at / quarter_turn + 1e-9) + 1) * quarter_turn, end = std::min(axis, to);
    const int count = std::max(1, int(std::ceil((end - at) / step)));
    for (int i = 1; i < count; ++i) add(at + (end - at) * i / count);
    add(end);
    at = end;
  }
}

TurnedPolygon outline_of(const InsertBody& body, double chord) {
  TurnedPolygon outline;
  for (std::size_t k = 0, n = body.corners.size(); k < n; ++k) {
    const InsertCorner& corner = body.corners[k];
    if (!(corner.radius > 0)) {
      add_point(outline, vec_of(corner.centre));
      continue;
    }
    const double from = angle_of(body.outward[(k + n - 1) % n]);
    double to = angle_of(body.outward[k]);
    if (to < from) to += full_turn;
    add_arc(outline, corner, from, to, chord);
  }
  while (outline.size() > 1 && length(outline.front() - outline.back()) <= same_point) outline.pop_back();
  return outline;
}

/// Returns the outline of a convex polygon without arcs.
InsertBody body_of(ToolPart part, const std::vector<InsertPoint>& corners) {
  InsertBody body{part, {}, {}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 delta = vec_of(corners[(i + 1) % corners.size()]) - vec_of(corners[i]);
    body.corners.push_back({corners[i], 0});
    body.outward.push_back({delta.y / length(delta), -delta.x / length(delta)});
  }
  return body;
}

/// Returns the section of a solid of revolution through its axis. A ball or torus gets its whole circle: the part of the tool above it is
/// at least as wide.
InsertBody section_of(ToolPart part, const RoundSolid& s) {
  const double r = s.top_radius, low = s.form == RoundSolid::Form::cone ? s.bottom_radius : r;
  if (s.form == RoundSolid::Form::ball) {
    const InsertCorner disc{{0, s.top}, r};
    const double half = 0.5, root = std::sqrt(3.0) / 2;
    return {part, {disc, disc, disc}, {{-1, 0}, {half, -root}, {half, root}}};
  }
  if (s.form == RoundSolid::Form::torus) {
    const double round = s.top - s.bottom;
    const InsertCorner left{{-s.bottom_radius, s.top}, round}, right{{s.bottom_radius, s.top}, round};
    return {part, {left, right}, {{0, -1}, {0, 1}}};
  }
  if (!(low > 0)) return body_of(part, {{0, s.bottom}, {r, s.top}, {-r, s.top}});
  if (!(r > 0)) return body_of(part, {{-low, s.bottom}, {low, s.bottom}, {0, s.top}});
  return body_of(part, {{-low, s.bottom}, {low, s.bottom}, {r, s.top}, {-r, s.top}});
}

}  // namespace

InsertSweep::InsertSweep(const InsertBody& body, double chord) : body_(body), outline_(outline_of(body, chord)) {}

Vec2 InsertSweep::farthest(Vec2 direction) const {
  const InsertCorner* best = &body_.corners.front();
  const auto reach = [&](const InsertCorner& c) { return dot(vec_of(c.centre), direction) + c.radius; };
  for (const InsertCorner& c : body_.corners)
    if (reach(c) > reach(*best)) best = &c;
  return vec_of(best->centre) + best->radius * direction;
}

std::size_t InsertSweep::farthest_corner(Vec2 direction) const {
  std::size_t best = 0;
  for (std::size_t i = 1; i < outline_.size(); ++i)
    if (dot(outline_[i], direction) > dot(outline_[best], direction)) best = i;
  return best;
}

TurnedPolygon InsertSweep::swept(Vec2 from, Vec2 to) const {
  const Vec2 d = to - from;
  const double far = length(d);
  TurnedPolygon area;
  area.reserve(outline_.size() + 4);
  if (far <= same_point) {
    for (const Vec2 p : outline_) area.push_back(p + from);
    return area;
  }
  const Vec2 right = {d.y / far, -d.x / far}, left = -1.0 * right;
  const Vec2 s1 = farthest(right), s2 = farthest(left);
  const std::size_t n = outline_.size(), i1 = farthest_corner(right), i2 = farthest_corner(left);
  // The corners next to s1 and s2 belong to the front if they lie farther along d, to the back if they lie farther back.
  const double along1 = dot(outline_[i1] - s1, d) / far, along2 = dot(outline_[i2] - s2, d) / far;
  const auto chain = [&](std::size_t first, std::size_t last, bool has_first, bool has_last, Vec2 shift) {
    const std::size_t count = (last + n - first) % n + 1;
    for (std::size_t k = has_first ? 0 : 1; k + (has_last ? 0 : 1) < count; ++k) add_point(area, outline_[(first + k) % n] + shift);
  };
  add_point(area, s1 + to);
  chain(i1, i2, along1 > same_point, along2 > same_point, to);
  add_point(area, s2 + to);
  add_point(area, s2 + from);
  chain(i2, i1, along2 < -same_point, along1 < -same_point, from);
  add_point(area, s1 + from);
  return area;
}

std::vector<InsertSweep> insert_sweeps(const ToolShape& tool, double chord) {
  std::vector<InsertSweep> sweeps;
  for (const InsertBody& body : tool.insert) sweeps.emplace_back(body, chord);
  for (const ConvexBody& body : tool.bodies)
    for (const RoundSolid& solid : body.solids)
      if (solid.top > solid.bottom && solid.widest() > 0) sweeps.emplace_back(section_of(body.part, solid), chord);
  return sweeps;
}

}  // namespace kadr
