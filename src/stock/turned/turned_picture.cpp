// Makes the surface of a turned part for its picture. Used by cli/cut_turned; tested by tests/stock/turned_picture_test.cpp.

#include "stock/turned/turned_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "stock/turned/edge_distance.h"
#include "stock/turned/few_corners.h"
#include "stock/turned/thread_surface.h"
#include "stock/turned/turned_mesh.h"
#include "stock/turned/turned_surface.h"

namespace kadr {
namespace {

constexpr double on_pictured_surface = 1e-4;  // mm; an edge this near to an earlier surface has not been cut since
constexpr double pictured_axis = 1e-6;        // mm
constexpr int least_picture_chords = 240;     // around the axis, so that the shading is smooth; a multiple of 4
constexpr double most_edge_parts = 2000;      // of an edge
constexpr int thread_steps = 16;              // samples along Z per lead of a thread
constexpr double whole_turn = 2 * std::numbers::pi;

bool lies_on_region(Vec2 a, Vec2 b, const TurnedRegion& region) {
  const Vec2 middle = 0.5 * (a + b);
  for (const TurnedPolygon& polygon : region)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 c = polygon[i], d = polygon[(i + 1) % polygon.size()];
      if (distance_to_edge(middle, c, d) < on_pictured_surface && std::fabs(cross(b - a, d - c)) <= 1e-3 * length(b - a) * length(d - c))
        return true;
    }
  return false;
}

std::int32_t maker_of(Vec2 a, Vec2 b, const std::vector<TurnedStage>& stages) {
  for (auto stage = stages.rbegin(); stage != stages.rend(); ++stage)
    if (!lies_on_region(a, b, stage->before)) return stage->maker;
  return of_blank;
}

/// A polygon with the corners that the picture needs. `maker` is of the edge that follows a corner.
struct Outline {
  TurnedPolygon corners;
  std::vector<std::int32_t> maker;
};

Outline outline_of(const TurnedPolygon& p, const std::vector<TurnedStage>& stages, double deviation, double longest) {
  std::vector<std::int32_t> makers;
  for (std::size_t i = 0; i < p.size(); ++i) makers.push_back(maker_of(p[i], p[(i + 1) % p.size()], stages));
  std::vector<bool> needed(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) needed[i] = makers[i] != makers[(i + p.size() - 1) % p.size()];
  needed = needed_corners(p, needed, deviation);
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (needed[i]) corners.push_back(i);
  Outline outline;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 a = p[corners[i]], d = p[corners[(i + 1) % corners.size()]] - a;
    const int parts = std::max(1, int(std::min(std::ceil(length(d) / longest), most_edge_parts)));
    for (int k = 0; k < parts; ++k) outline.corners.push_back(a + (double(k) / parts) * d), outline.maker.push_back(makers[corners[i]]);
  }
  return outline;
}

class Revolving {
 public:
  Revolving(Surface& surface, int chords, bool is_cut) : surface_(surface), chords_(chords), first_(is_cut ? chords / 4 : 0) {}

  /// Adds the cone or disc of an edge. Its points are its own, so that colours do not run into each other.
  void edge(Vec2 a, Vec2 b, std::int32_t maker) {
    if (a.x <= pictured_axis && b.x <= pictured_axis) return;
    const std::uint32_t from = circle(a, maker), to = circle(b, maker);
    for (std::uint32_t k = 0; k < std::uint32_t(chords_ - first_); ++k) {
      if (a.x > pictured_axis) triangle(from + k, from + k + 1, to + k + 1);
      if (b.x > pictured_axis) triangle(from + k, to + k + 1, to + k);
    }
  }

  void thread(const ShownEdge& edge, const ThreadedPart& threaded) {
    const auto add_point = [this](int chord, double radius, double z, std::int32_t maker) { return point({radius, z}, chord, maker); };
    add_thread(edge, threaded, {chords_, first_, thread_steps}, add_point,
               [this](std::uint32_t a, std::uint32_t b, std::uint32_t c) { triangle(a, b, c); });
  }

  /// Adds a trapezoid of the section at an edge of the missing quarter: between the radii r0 and r1 at the Z `low`, and s0 and s1 at the Z
  /// `high`. `is_last`: at the last chord of the surface, else at the first one.
  void section(bool is_last, double low, double r0, double r1, double high, double s0, double s1) {
    const int chord = is_last ? chords_ : first_;
    const std::uint32_t a = point({r0, low}, chord, of_blank), b = point({r1, low}, chord, of_blank),
                        c = point({s1, high}, chord, of_blank), d = point({s0, high}, chord, of_blank);
    for (const auto& [i, j, k] : {std::array{a, b, c}, std::array{a, c, d}}) is_last ? triangle(i, k, j) : triangle(i, j, k);
  }

 private:
  std::uint32_t point(Vec2 corner, int chord, std::int32_t maker) {
    const double angle = whole_turn * (chord % chords_) / chords_;
    const Vec3 at = as_pictured({corner.x * std::cos(angle), corner.x * std::sin(angle), corner.y});
    for (const double value : {at.x, at.y, at.z}) surface_.points.push_back(float(value));
    surface_.made_by.push_back(maker);
    return std::uint32_t(surface_.made_by.size() - 1);
  }
  std::uint32_t circle(Vec2 corner, std::int32_t maker) {
    const auto first = std::uint32_t(surface_.made_by.size());
    for (int chord = first_; chord <= chords_; ++chord) point(corner, chord, maker);
    return first;
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { surface_.triangles.insert(surface_.triangles.end(), {a, b, c}); }

  Surface& surface_;
  int chords_, first_;  // chords of a full turn; the first one that is not cut out
};

/// Adds a cut face of the missing quarter, divided into trapezoids between the heights of its corners.
void add_section(const TurnedRegion& face, bool is_last, Revolving& to) {
  std::vector<double> heights;
  for (const TurnedPolygon& polygon : face)
    for (const Vec2 corner : polygon) heights.push_back(corner.y);
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end(), [](double a, double b) { return b - a < on_pictured_surface; }), heights.end());
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const double low = heights[i], high = heights[i + 1], middle = 0.5 * (low + high);
    std::vector<std::array<double, 3>> across;  // radii of an edge in the middle, below, above
    for (const TurnedPolygon& polygon : face)
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 a = polygon[k], b = polygon[(k + 1) % polygon.size()];
        if ((a.y > middle) == (b.y > middle)) continue;
        const auto at = [&](double z) { return a.x + (b.x - a.x) * std::clamp((z - a.y) / (b.y - a.y), 0.0, 1.0); };
        across.push_back({at(middle), at(low), at(high)});
      }
    std::sort(across.begin(), across.end());
    for (std::size_t k = 0; k + 1 < across.size(); k += 2)
      to.section(is_last, low, across[k][1], across[k + 1][1], high, across[k][2], across[k + 1][2]);
  }
}

/// Adds the surface of an edge, with its threads.
void add_edge(const ShownEdge& edge, const std::vector<ThreadGroove>& threads, Revolving& to) {
  const std::optional<ThreadedPart> threaded = threads_on(edge, threads);
  if (!threaded) return to.edge(edge.a, edge.b, edge.maker);
  const double first = edge.is_outer() ? threaded->low : threaded->high, last = edge.is_outer() ? threaded->high : threaded->low;
  if (edge.a.y != first) to.edge(edge.a, {edge.radius(first), first}, edge.maker);
  to.thread(edge, *threaded);
  if (edge.b.y != last) to.edge({edge.radius(last), last}, edge.b, edge.maker);
}

}  // namespace

Surface turned_picture(const TurnedRegion& region, const std::vector<TurnedStage>& stages, const std::vector<ThreadGroove>& threads,
                       double deviation, double longest) {
  std::vector<Outline> outlines;
  double widest = 0;
  bool has_bore = false;
  for (const TurnedPolygon& polygon : region) {
    outlines.push_back(outline_of(polygon, stages, deviation / 2, longest));
    const TurnedPolygon& corners = outlines.back().corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
      widest = std::max(widest, a.x);
      // polygons are counter-clockwise, so an edge towards smaller Z faces the axis
      has_bore = has_bore || (b.y < a.y - on_pictured_surface && std::max(a.x, b.x) > pictured_axis);
    }
  }
  Surface surface;
  const int chords = (std::max(least_picture_chords, chords_around(widest, deviation / 2)) + 3) / 4 * 4;
  Revolving revolving(surface, chords, has_bore);
  for (const Outline& outline : outlines)
    for (std::size_t i = 0; i < outline.corners.size(); ++i)
      add_edge({outline.corners[i], outline.corners[(i + 1) % outline.corners.size()], outline.maker[i]}, threads, revolving);
  if (has_bore)
    for (const bool is_last : {false, true})
      add_section(turned_section({region, threads, {}, deviation}, is_last ? 0 : whole_turn / 4), is_last, revolving);
  return surface;
}

}  // namespace kadr
