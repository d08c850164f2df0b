// Revolves the region of a turned part for display. Used by view/turned_part; tested by tests/stock/turned_surface_test.cpp.

#include "stock/turned/turned_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stock/turned/few_corners.h"

namespace kadr {
namespace {

constexpr double surface_axis = 1e-6;  // mm; a corner this near to the axis lies on it
constexpr double least_groove = 1e-3;  // mm; a groove that is shallower is not drawn
constexpr double straight_angle = std::numbers::pi;
// rad; at a corner that turns by less the surface is smooth: chords of an arc, within `edge_deviation`
constexpr double least_turn = 10 * straight_angle / 180;
constexpr double edge_deviation = 5e-4;                         // mm
constexpr int fewest_ring_chords = 24, most_ring_chords = 256;  // chords around the axis
constexpr int finest_steps = 32, coarsest_steps = 6;            // samples along Z per lead of a thread
constexpr double thread_points = 150'000;                       // about the greatest number of points of all threads

/// An edge of the region with what made it.
struct ShownEdge {
  Vec2 a, b;
  std::int32_t maker = -1;

  bool is_outer() const { return b.y > a.y; }  // the outside is to the right of an edge
  double radius(double z) const { return a.y == b.y ? a.x : a.x + (b.x - a.x) * (z - a.y) / (b.y - a.y); }
  double low() const { return std::min(a.y, b.y); }
  double high() const { return std::max(a.y, b.y); }
};

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

/// The threads that cut an edge, and the part of the edge that they reach.
struct ThreadedPart {
  std::vector<const ThreadGroove*> grooves;
  double low = 0, high = 0;  // Z, mm

  double pitch() const { return grooves.front()->lead; }
  /// Returns the radius of the surface at a place of the edge, and who made it.
  std::pair<double, std::int32_t> at(const ShownEdge& edge, double angle, double z) const {
    std::pair<double, std::int32_t> result{edge.radius(z), edge.maker};
    for (const ThreadGroove* const groove : grooves) {
      const double radius = std::max(groove->radius(angle, z), groove->is_outer ? 0.0 : -1.0);
      if (groove->is_outer ? radius < result.first - least_groove : radius > result.first + least_groove) result = {radius, groove->maker};
    }
    return result;
  }
};

/// Returns the threads on an edge; nullopt if there is none. The deepest groove comes first.
std::optional<ThreadedPart> threads_on(const ShownEdge& edge, const std::vector<ThreadGroove>& threads) {
  ThreadedPart part;
  part.low = edge.high(), part.high = edge.low();
  const auto deeper = [](const ThreadGroove* a, const ThreadGroove* b) {
    return a->is_outer ? a->from.x + a->to.x < b->from.x + b->to.x : a->from.x + a->to.x > b->from.x + b->to.x;
  };
  for (const ThreadGroove& groove : threads) {
    if (groove.is_outer != edge.is_outer() || edge.a.y == edge.b.y || !(groove.lead > 0)) continue;
    const Vec2 reach = groove.reach();
    const double low = std::max(edge.low(), reach.x), high = std::min(edge.high(), reach.y);
    if (!(low < high)) continue;
    const double tip = groove.is_outer ? std::min(groove.from.x, groove.to.x) : std::max(groove.from.x, groove.to.x);
    const double edge_most = std::max(edge.a.x, edge.b.x), edge_least = std::min(edge.a.x, edge.b.x);
    if (groove.is_outer ? tip > edge_most - least_groove : tip < edge_least + least_groove) continue;
    part.grooves.push_back(&groove);
    part.low = std::min(part.low, low), part.high = std::max(part.high, high);
  }
  if (part.grooves.empty()) return std::nullopt;
  std::stable_sort(part.grooves.begin(), part.grooves.end(), deeper);
  return part;
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
    add_thread(edge, *threaded);
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

  /// Adds the helical surface. Its rows follow the helix, so that crests and roots are lines of the mesh; rows beyond the ends lie on the
  /// ends.
  void add_thread(const ShownEdge& edge, const ThreadedPart& part) {
    const ThreadGroove& deepest = *part.grooves.front();
    const double step = deepest.lead / steps_, hand = deepest.left_handed ? -1 : 1;
    const int from = int(std::floor((part.low - deepest.start - deepest.lead) / step));
    const int to = int(std::ceil((part.high - deepest.start + deepest.lead) / step));
    const auto columns = std::uint32_t(to - from + 1), first = std::uint32_t(made_.point_count());
    const auto z_of = [&](int k, int j) {
      return std::clamp(deepest.start + hand * deepest.lead * k / chords_ + j * step, part.low, part.high);
    };
    for (int k = 0; k <= chords_; ++k)
      for (int j = from; j <= to; ++j) {
        const double z = z_of(k, j), angle = 2 * straight_angle * k / chords_;
        const auto [radius, maker] = part.at(edge, angle, z);
        add_point(angle, radius, z, maker);
      }
    for (int k = 0; k < chords_; ++k)
      for (int j = from; j < to; ++j) {
        const std::uint32_t here = first + std::uint32_t(k) * columns + std::uint32_t(j - from), next = here + columns;
        const bool outer = edge.is_outer();
        if (z_of(k, j) != z_of(k, j + 1)) outer ? add_triangle(here, next, here + 1) : add_triangle(here, here + 1, next);
        if (z_of(k + 1, j) != z_of(k + 1, j + 1)) outer ? add_triangle(next, next + 1, here + 1) : add_triangle(next, here + 1, next + 1);
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
