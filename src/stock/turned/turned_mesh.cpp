// Revolves polygons. Used by cli/cut_turned; tested by tests/stock/turned_stock_test.cpp.

#include "stock/turned/turned_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stock/turned/few_corners.h"

namespace kadr {
namespace {

constexpr double at_axis = 1e-6;                      // mm; a corner this near to the axis lies on it
constexpr int least_chords = 12, most_chords = 4096;  // chords around the axis

TurnedPolygon simplified(const TurnedPolygon& p, double deviation) {
  const std::vector<bool> needed = needed_corners(p, {}, deviation);
  TurnedPolygon few;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (needed[i]) few.push_back(p[i]);
  return few.size() >= 3 ? few : p;
}

/// Adds the circle of points that a corner describes; a corner on the axis is one point. Returns the number of the first point.
std::uint32_t add_circle(Mesh& mesh, Vec2 corner, int chords) {
  const auto first = std::uint32_t(mesh.point_count());
  const int count = corner.x <= at_axis ? 1 : chords;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / chords, r = count == 1 ? 0 : corner.x;
    for (const double value : {r * std::cos(angle), r * std::sin(angle), corner.y}) mesh.points.push_back(float(value));
  }
  return first;
}

/// Adds the triangles between the circles of two corners. Polygons are counter-clockwise with the radius to the right, so the outside is
/// to the right of each edge.
void add_cone(Mesh& mesh, std::uint32_t a, std::uint32_t b, bool a_point, bool b_point, std::uint32_t chords) {
  for (std::uint32_t k = 0; k < chords; ++k) {
    const std::uint32_t next = (k + 1) % chords;
    if (!a_point) mesh.triangles.insert(mesh.triangles.end(), {a + k, a + next, b_point ? b : b + next});
    if (!b_point) mesh.triangles.insert(mesh.triangles.end(), {a_point ? a : a + k, b + next, b + k});
  }
}

}  // namespace

int chords_around(double radius, double deviation) {
  if (!(deviation < radius)) return least_chords;
  return std::clamp(int(std::ceil(std::numbers::pi / std::acos(1 - deviation / radius))), least_chords, most_chords);
}

Mesh turned_mesh(const TurnedRegion& region, double deviation) {
  Mesh mesh;
  double widest = 0;
  for (const TurnedPolygon& polygon : region)
    for (const Vec2 p : polygon) widest = std::max(widest, p.x);
  const int chords = chords_around(widest, deviation / 2);
  for (const TurnedPolygon& polygon : region) {
    const TurnedPolygon few = simplified(polygon, deviation / 2);
    std::vector<std::uint32_t> circles;
    for (const Vec2 p : few) circles.push_back(add_circle(mesh, p, chords));
    for (std::size_t i = 0; i < few.size(); ++i) {
      const std::size_t next = (i + 1) % few.size();
      const bool a_point = few[i].x <= at_axis, b_point = few[next].x <= at_axis;
      if (!a_point || !b_point) add_cone(mesh, circles[i], circles[next], a_point, b_point, std::uint32_t(chords));
    }
  }
  return mesh;
}

}  // namespace kadr
