// Revolves the region of a turned part for display. Used by view/turned_part; tested by tests/stock/turned_surface_test.cpp.

#include "stock/turned/turned_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stock/turned/few_corners.h"
#include "stock/turned/thread_surface.h"

namespace kadr {
namespace {

constexpr double surface_axis = 1e-6;  // mm; a corner this near to the axis lies on it
constexpr double straight_angle = std::numbers::pi;
// rad; at a corner that turns by less the surface is smooth: chords of an arc, within `edge_deviation`
constexpr double least_turn = 10 * straight_angle / 180;
constexpr double edge_deviation = 5e-4;                         // mm
constexpr int fewest_ring_chords = 24, most_ring_chords = 256;  // chords around the axis
constexpr int finest_steps = 32, coarsest_steps = 6;            // samples along Z per lead of a thread
constexpr double thread_points = 150'000;                       // about the greatest number of points of all threads

using EdgeLoop = std::vector<ShownEdge>;

/// Returns the edges of a polygon with few corners; edges of different makers are not joined.
EdgeLoop shown_edges(const TurnedPolygon& polygon, const TurnedView& part) {
  const std::size_t n = polygon.size();
  std::vector<std::int32_t> makers(n);
  for (std::size_t i = 0; i < n; ++i) makers[i] = part.maker_of ? part.maker_of(polygon[i], polygon[(i + 1) % n]) : -1;
  std::vector<bool> fixed(n);
  for (std::size_t i = 0; i < n; ++i) fixed[i] = makers[i] != makers[(i + n - 1) % n];
  const std::vector<bool> needed = needed_corners(polygon, fixed, part.deviation / 2);
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < n; ++i)
    if (needed[i]) corners.push_back(i);
  EdgeLoop edges;
  for (std::size_t k = 0; k < corners.size(); ++k)
    edges.push_back({polygon[corners[k]], polygon[corners[(k + 1) % corners.size()]], makers[corners[k]]});
  return edges;
}

int ring_chords(double radius, double deviation) {
  if (!(deviation < radius)) return fewest_ring_chords;
  return std::clamp(int(std::ceil(straight_angle / std::acos(1 - deviation / radius))), fewest_ring_chords, most_ring_chords);
}

class SurfaceMaker {
 public:
  SurfaceMaker(const TurnedView& part) : part_(part) {
    double widest = 0;
    for (const TurnedPolygon& polygon : part.region)
      for (const Vec2 p : polygon) widest = std::max(widest, p.x);
    chords_ = ring_chords(widest, part.deviation / 2);
    double turns = 0;
    for (const TurnedPolygon& polygon : part.region)
      for (const ShownEdge& edge : loops_.emplace_back(shown_edges(polygon, part)))
        if (const auto threaded = threads_on(edge, part.threads)) turns += (threaded->high - threaded->low) / threaded->pitch() + 2;
    steps_ = turns > 0 ? std::clamp(int(thread_points / (turns * chords_)), coarsest_steps, finest_steps) : finest_steps;
  }

  Surface make() {
    for (const EdgeLoop& loop : loops_)
      for (const ShownEdge& edge : loop) add(edge);
    return std::move(made_);
  }

 private:
  void add(const ShownEdge& edge) {
    const auto threaded = threads_on(edge, part_.threads);
    if (!threaded) return add_cone(edge, edge.a, edge.b);
    const auto corner = [&](double z) { return Vec2{edge.radius(z), z}; };
    const double first = edge.is_outer() ? threaded->low : threaded->high, last = edge.is_outer() ? threaded->high : threaded->low;
    add_cone(edge, edge.a, corner(first));
    const auto point = [this](int chord, double radius, double z, std::int32_t maker) {
      return add_point(2 * straight_angle * chord / chords_, radius, z, maker);
    };
    add_thread(edge, *threaded, {chords_, 0, steps_}, point,
               [this](std::uint32_t i, std::uint32_t j, std::uint32_t k) { add_triangle(i, j, k); });
    add_cone(edge, corner(last), edge.b);
  }

  std::uint32_t add_point(double angle, double radius, double z, std::int32_t maker) {
    for (const double value : {radius * std::cos(angle), radius * std::sin(angle), z}) made_.points.push_back(float(value));
    made_.made_by.push_back(maker);
    return std::uint32_t(made_.point_count() - 1);
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { made_.triangles.insert(made_.triangles.end(), {a, b, c}); }

  /// Adds the cone between the circles of two corners; the outside is to the right of the way from a to b.
  void add_cone(const ShownEdge& edge, Vec2 a, Vec2 b) {
    if (a == b || (a.x <= surface_axis && b.x <= surface_axis)) return;
    const auto n = std::uint32_t(chords_);
    std::uint32_t first[2];
    for (int side = 0; side < 2; ++side) {
      const Vec2 corner = side == 0 ? a : b;
      first[side] = std::uint32_t(made_.point_count());
      for (std::uint32_t k = 0; k < n; ++k) add_point(2 * straight_angle * k / n, corner.x, corner.y, edge.maker);
    }
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t next = (k + 1) % n;
      if (a.x > surface_axis) add_triangle(first[0] + k, first[0] + next, first[1] + next);
      if (b.x > surface_axis) add_triangle(first[0] + k, first[1] + next, first[1] + k);
    }
  }

  const TurnedView& part_;
  std::vector<EdgeLoop> loops_;
  int chords_ = fewest_ring_chords, steps_ = finest_steps;
  Surface made_;
};

void add_section_corner(TurnedPolygon& polygon, Vec2 corner) {
  if (polygon.empty() || !(polygon.back() == corner)) polygon.push_back(corner);
}

}  // namespace

Surface turned_surface(const TurnedView& part) { return SurfaceMaker(part).make(); }

TurnedRegion turned_section(const TurnedView& part, double angle) {
  TurnedRegion section;
  for (const TurnedPolygon& polygon : part.region) {
    TurnedPolygon& cut = section.emplace_back();
    for (const ShownEdge& edge : shown_edges(polygon, part)) {
      add_section_corner(cut, edge.a);
      const auto threaded = threads_on(edge, part.threads);
      if (!threaded) continue;
      const double first = edge.is_outer() ? threaded->low : threaded->high, last = edge.is_outer() ? threaded->high : threaded->low;
      const int count = std::max(1, int(std::ceil(std::fabs(last - first) / threaded->pitch() * finest_steps)));
      add_section_corner(cut, {edge.radius(first), first});
      for (int i = 0; i <= count; ++i) {
        const double z = first + (last - first) * i / count;
        add_section_corner(cut, {threaded->at(edge, angle, z).first, z});
      }
      add_section_corner(cut, {edge.radius(last), last});
    }
  }
  return section;
}

std::vector<Vec2> turned_edges(const TurnedView& part) {
  std::vector<Vec2> corners;
  for (const TurnedPolygon& polygon : part.region) {
    const EdgeLoop edges = shown_edges(polygon, {part.region, part.threads, {}, edge_deviation});
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const ShownEdge &before = edges[(i + edges.size() - 1) % edges.size()], &after = edges[i];
      const Vec2 a = before.b - before.a, b = after.b - after.a;
      const double turn = std::fabs(std::atan2(cross(a, b), dot(a, b)));
      if (after.a.x > surface_axis && turn > least_turn) corners.push_back(after.a);
    }
  }
  return corners;
}

}  // namespace kadr
