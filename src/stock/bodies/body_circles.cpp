// Approximates bodies of revolution by circles. Used by stock/bodies/body_world; tested by tests/stock/body_world_test.cpp.

#include <algorithm>
#include <cmath>

#include "stock/bodies/body_world.h"

namespace kadr {
namespace {

constexpr double same_circle = 1e-9;  // limit in mm: circles whose heights differ by less count as one

/// Replaces a quarter circle about (x, y) with the radius r by straight tangent lines, and appends the corners of these lines to `profile`.
/// The quarter circle goes from the point below the centre to the point at the height of the centre.
void add_arc(std::vector<Vec2>& profile, double x, double y, double r, double chord) {
  // The corners where two tangent lines meet are about `chord` mm outside the circle.
  const double half = std::acos(1 / (1 + std::max(chord, 1e-9) / r));
  const int count = std::clamp(int(std::ceil(pi / 4 / half)), 2, 64);
  const double step = pi / 2 / count, about = r / std::cos(step / 2);
  profile.push_back({x, y - r});
  for (int i = 0; i < count; ++i) {
    const double angle = (i + 0.5) * step;
    profile.push_back({x + about * std::sin(angle), y - about * std::cos(angle)});
  }
  profile.push_back({x + r, y});
}

void add_solid(std::vector<Vec2>& profile, const RoundSolid& s, double chord) {
  switch (s.form) {
    case RoundSolid::Form::cylinder: profile.push_back({s.top_radius, s.bottom}); break;
    case RoundSolid::Form::cone: profile.push_back({s.bottom_radius, s.bottom}); break;
    case RoundSolid::Form::ball: add_arc(profile, 0, s.top, s.top_radius, chord); break;
    case RoundSolid::Form::torus: add_arc(profile, s.bottom_radius, s.top, s.top_radius - s.bottom_radius, chord); break;
  }
  profile.push_back({s.top_radius, s.top});
}

}  // namespace

/// Returns the circles (radius and height) whose convex hull encloses the body, in ascending order of height. They are the outer side of
/// the convex hull of the outline (Andrew's monotone chain), including both ends. An end of radius 0 is a single point.
std::vector<Vec2> circles_of(const ConvexBody& body, double chord) {
  std::vector<Vec2> profile;
  for (const RoundSolid& s : body.solids) add_solid(profile, s, chord);
  std::sort(profile.begin(), profile.end(), [](Vec2 a, Vec2 b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  std::vector<Vec2> hull;
  for (const Vec2& p : profile) {
    while (hull.size() >= 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= same_circle * same_circle) hull.pop_back();
    hull.push_back(p);
  }
  // Of several circles at the same height, only the widest remains.
  std::vector<Vec2> circles;
  for (const Vec2& p : hull) {
    if (!circles.empty() && p.y - circles.back().y < same_circle) circles.back().x = std::max(circles.back().x, p.x);
    else circles.push_back(p);
  }
  return circles;
}

}  // namespace kadr
