// Revolves polygons. Used by cli/cut_turned; tested by tests/stock/turned_stock_test.cpp.

#include "stock/turned/turned_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stock/turned/edge_distance.h"

namespace kadr {
namespace {

constexpr double at_axis = 1e-6;                      // mm; a corner this near to the axis lies on it
constexpr int least_chords = 12, most_chords = 4096;  // chords around the axis

/// Marks the corners between two others that a polyline within `deviation` mm needs (Douglas, Peucker 1973).
void mark(const TurnedPolygon& p, std::size_t first, std::size_t last, double deviation, std::vector<bool>& needed) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    double most = deviation;
    std::size_t farthest = a;
    for (std::size_t i = a + 1; i < b; ++i)
      if (const double off = distance_to_edge(p[i], p[a], p[b % p.size()]); off > most) most = off, farthest = i;
    if (farthest == a) continue;
    needed[farthest] = true;
    open.push_back({a, farthest});
    open.push_back({farthest, b});
  }
}

TurnedPolygon simplified(const TurnedPolygon& p, double deviation) {
  std::vector<bool> needed(p.size());
  std::size_t opposite = 0;
  for (std::size_t i = 1; i < p.size(); ++i)
    if (length(p[i] - p[0]) > length(p[opposite] - p[0])) opposite = i;
  needed[0] = needed[opposite] = true;
  mark_needed_corners(p, deviation, needed);
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

void mark_needed_corners(const TurnedPolygon& polygon, double deviation, std::vector<bool>& needed) {
  std::vector<std::size_t> fixed;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (needed[i]) fixed.push_back(i);
  for (std::size_t k = 0; k + 1 < fixed.size(); ++k) mark(polygon, fixed[k], fixed[k + 1], deviation, needed);
  if (fixed.front() == 0) {
    mark(polygon, fixed.back(), polygon.size(), deviation, needed);
    return;
  }
  TurnedPolygon last(polygon.begin() + std::ptrdiff_t(fixed.back()), polygon.end());  // from the last fixed corner over 0 to the first one
  last.insert(last.end(), polygon.begin(), polygon.begin() + std::ptrdiff_t(fixed.front()) + 1);
  std::vector<bool> of_last(last.size());
  mark(last, 0, last.size() - 1, deviation, of_last);
  for (std::size_t i = 0; i < last.size(); ++i)
    if (of_last[i]) needed[(fixed.back() + i) % polygon.size()] = true;
}

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
