// Compares turned parts. Used by cli/cut_turned; tested by tests/stock/turned_part_test.cpp.

#include "stock/turned/turned_part.h"

#include <algorithm>
#include <clipper.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "stock/turned/edge_distance.h"

namespace kadr {

namespace cl = ClipperLib;

namespace {

constexpr double units_of_mm = 1e6;           // units of Clipper per mm
constexpr double rounding_depth = 0.002;      // mm; differences that are nowhere deeper are rounding
constexpr double beside_corner = 1e-7;        // rad; the section passes the corners of the mesh at this angle
constexpr double same_section_corner = 1e-5;  // mm; ends of lines that are closer are joined
constexpr double near_axis = 1e-4;            // mm
constexpr double least_measured_step = 0.05;  // mm; distances are measured along an edge in steps of at least this length
constexpr double most_facets = 0.05;          // a body of revolution loses less of its volume to 12 facets or more
constexpr double steps_of_region = 4000;      // and in at most about as many steps in all

/// Returns the distance of a point from the surface of the body; edges on the axis are inside the body.
double distance_to_surface(const TurnedRegion& region, Vec2 p) {
  double least = 1e300;
  for (const TurnedPolygon& polygon : region)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if (a.x > near_axis || b.x > near_axis) least = std::min(least, distance_to_edge(p, a, b));
    }
  return least;
}

struct Segment {
  Vec2 from, to;
};

/// Returns the lines in which a half plane at an angle about Z meets the triangles. The body lies to the left of each line.
std::vector<Segment> section_lines(const Mesh& mesh, double angle) {
  const Vec3 along{std::cos(angle), std::sin(angle), 0}, across{-std::sin(angle), std::cos(angle), 0};
  std::vector<Segment> lines;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    Vec2 place[3];
    double side[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = mesh.corner(t, k);
      place[k] = {p.x * along.x + p.y * along.y, p.z};
      side[k] = p.x * across.x + p.y * across.y;
    }
    Vec2 in, out;
    int met = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if ((side[k] < 0) == (side[next] < 0)) continue;
      const Vec2 at = place[k] + side[k] / (side[k] - side[next]) * (place[next] - place[k]);
      (side[k] < 0 ? out : in) = at;
      ++met;
    }
    if (met != 2 || in.x + out.x <= 0) continue;
    lines.push_back({out, in});
  }
  return lines;
}

/// Joins lines to closed polygons. Ends on the axis are joined along it. Returns an empty region if ends remain.
TurnedRegion joined_lines(const std::vector<Segment>& lines) {
  const auto key = [](Vec2 p) {
    return std::pair(std::llround(p.x / same_section_corner / 4), std::llround(p.y / same_section_corner / 4));
  };
  std::multimap<std::pair<long long, long long>, std::size_t> begins;
  for (std::size_t i = 0; i < lines.size(); ++i) begins.emplace(key(lines[i].from), i);
  std::vector<bool> used(lines.size());
  const auto next_of = [&](Vec2 end) -> std::optional<std::size_t> {
    const auto [x, y] = key(end);
    std::optional<std::size_t> best;
    for (long long dx = -1; dx <= 1; ++dx)
      for (long long dy = -1; dy <= 1; ++dy)
        for (auto [at, last] = begins.equal_range({x + dx, y + dy}); at != last; ++at)
          if (!used[at->second] && (!best || length(lines[at->second].from - end) < length(lines[*best].from - end))) best = at->second;
    if (best || std::fabs(end.x) > near_axis) return best;
    for (std::size_t i = 0; i < lines.size(); ++i)  // the nearest line that leaves the axis below
      if (!used[i] && std::fabs(lines[i].from.x) <= near_axis && lines[i].from.y <= end.y + same_section_corner &&
          (!best || lines[i].from.y > lines[*best].from.y))
        best = i;
    return best;
  };
  TurnedRegion region;
  for (std::size_t first = 0; first < lines.size(); ++first) {
    if (used[first]) continue;
    TurnedPolygon polygon;
    for (std::optional<std::size_t> at = first; at && !used[*at];) {
      used[*at] = true;
      if (polygon.empty() || length(polygon.back() - lines[*at].from) > same_section_corner) polygon.push_back(lines[*at].from);
      polygon.push_back(lines[*at].to);
      at = next_of(lines[*at].to);
    }
    const Vec2 gap = polygon.back() - polygon.front();
    if (length(gap) > 10 * same_section_corner && !(std::fabs(polygon.back().x) <= near_axis && std::fabs(polygon.front().x) <= near_axis))
      return {};
    for (Vec2& p : polygon) p.x = std::max(p.x, 0.0);
    region.push_back(std::move(polygon));
  }
  return region;
}

cl::Paths clipper_paths(const TurnedRegion& region) {
  cl::Paths paths;
  for (const TurnedPolygon& polygon : region) {
    cl::Path path;
    for (const Vec2 p : polygon) path.emplace_back(std::llround(p.x * units_of_mm), std::llround(p.y * units_of_mm));
    paths.push_back(std::move(path));
  }
  return paths;
}

TurnedRegion region_difference(const TurnedRegion& of, const TurnedRegion& without) {
  cl::Clipper clipper;
  clipper.AddPaths(clipper_paths(of), cl::ptSubject, true);
  clipper.AddPaths(clipper_paths(without), cl::ptClip, true);
  cl::PolyTree tree;
  clipper.Execute(cl::ctDifference, tree, cl::pftNonZero, cl::pftNonZero);
  cl::Paths paths;
  cl::ClosedPathsFromPolyTree(tree, paths);
  TurnedRegion region;
  for (const cl::Path& path : paths) {
    TurnedPolygon polygon;
    for (const cl::IntPoint& p : path) polygon.push_back({double(p.X) / units_of_mm, double(p.Y) / units_of_mm});
    region.push_back(std::move(polygon));
  }
  return region;
}

TurnedDifference measured_difference(const TurnedRegion& beyond, const TurnedRegion& wanted) {
  double around = 0;
  for (const TurnedPolygon& polygon : beyond)
    for (std::size_t i = 0; i < polygon.size(); ++i) around += length(polygon[(i + 1) % polygon.size()] - polygon[i]);
  const double step = std::max(least_measured_step, around / steps_of_region);
  TurnedDifference found;
  for (const TurnedPolygon& polygon : beyond) {
    double deepest = 0;
    Vec2 deep_at;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i], d = polygon[(i + 1) % polygon.size()] - a;
      const int parts = std::max(1, int(std::ceil(length(d) / step)));
      for (int k = 0; k < parts; ++k) {
        const Vec2 p = a + (double(k) / parts) * d;
        if (const double off = distance_to_surface(wanted, p); off > deepest) deepest = off, deep_at = p;
      }
    }
    const bool is_hole = volume_of(TurnedRegion{polygon}) < 0;
    if (!is_hole && deepest <= rounding_depth) continue;
    found.volume += volume_of(TurnedRegion{polygon});
    if (deepest > found.deepest) found.deepest = deepest, found.at = deep_at;
  }
  return found;
}

bool is_in_region(const TurnedRegion& region, Vec2 p) {
  bool inside = false;
  for (const TurnedPolygon& polygon : region)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
  return inside;
}

}  // namespace

double distance_from(const TurnedRegion& wanted, Vec2 at) { return (is_in_region(wanted, at) ? -1 : 1) * distance_to_surface(wanted, at); }

std::optional<TurnedRegion> section_of(const Mesh& mesh, double tolerance) {
  double farthest = 0, angle = 0;
  for (std::size_t i = 0; i < mesh.point_count(); ++i) {
    const Vec3 p = mesh.point(i);
    if (const double r = std::hypot(p.x, p.y); r > farthest) farthest = r, angle = std::atan2(p.y, p.x);
  }
  const TurnedRegion region = joined_lines(section_lines(mesh, angle + beside_corner));
  const double whole = volume_of(region);
  if (region.empty() || !(whole > 0) || std::fabs(volume_of(mesh) - whole) > most_facets * whole) return std::nullopt;
  for (std::size_t i = 0; i < mesh.point_count(); ++i) {
    const Vec3 p = mesh.point(i);
    if (const double r = std::hypot(p.x, p.y); r > near_axis && distance_to_surface(region, {r, p.z}) > tolerance) return std::nullopt;
  }
  return region;
}

TurnedComparison compare(const TurnedRegion& part, const TurnedRegion& wanted) {
  return {measured_difference(region_difference(part, wanted), wanted), measured_difference(region_difference(wanted, part), wanted)};
}

}  // namespace kadr
