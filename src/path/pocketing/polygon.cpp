// This file has operations on areas that are given by their corners; they are computed with the Clipper library. Used by out and path.

#include "path/pocketing/polygon.h"

#include <algorithm>
#include <clipper.hpp>
#include <cmath>

namespace kadr::area {
namespace {

namespace cl = ClipperLib;

// Clipper units per mm. Clipper calculates in integers; one unit is a nanometre, which is far below tol::area_chord.
constexpr double per_mm = 1e6;

cl::Paths to_clipper(const Polygons& polygons) {
  cl::Paths paths(polygons.size());
  for (std::size_t i = 0; i < polygons.size(); ++i)
    for (const Vec2 p : polygons[i]) paths[i].emplace_back(std::llround(p.x * per_mm), std::llround(p.y * per_mm));
  return paths;
}

Polygon from_clipper(const cl::Path& path) {
  Polygon polygon;
  polygon.reserve(path.size());
  for (const cl::IntPoint& p : path) polygon.push_back({static_cast<double>(p.X) / per_mm, static_cast<double>(p.Y) / per_mm});
  return polygon;
}

Polygons from_clipper(const cl::Paths& paths) {
  Polygons polygons;
  for (const cl::Path& path : paths) polygons.push_back(from_clipper(path));
  return polygons;
}

Polygons clip(cl::ClipType type, const Polygons& a, const Polygons& b) {
  cl::Clipper clipper;
  clipper.AddPaths(to_clipper(a), cl::ptSubject, true);
  clipper.AddPaths(to_clipper(b), cl::ptClip, true);
  cl::Paths result;
  clipper.Execute(type, result, cl::pftNonZero, cl::pftNonZero);
  return from_clipper(result);
}

Polygons clip_lines(cl::ClipType type, const Polygons& lines, const Polygons& areas) {
  cl::Clipper clipper;
  clipper.AddPaths(to_clipper(lines), cl::ptSubject, false);
  clipper.AddPaths(to_clipper(areas), cl::ptClip, true);
  cl::PolyTree tree;
  clipper.Execute(type, tree, cl::pftNonZero, cl::pftNonZero);
  cl::Paths result;
  cl::OpenPathsFromPolyTree(tree, result);
  return from_clipper(result);
}

Polygons offset(const Polygons& polygons, double by, double chord, cl::EndType ends) {
  cl::ClipperOffset offset(2, chord * per_mm);
  offset.AddPaths(to_clipper(polygons), cl::jtRound, ends);
  cl::Paths result;
  offset.Execute(result, by * per_mm);
  return from_clipper(result);
}

void take_parts(const cl::PolyNode& parent, std::vector<Polygons>& parts) {
  for (const cl::PolyNode* const outer : parent.Childs) {
    parts.push_back({from_clipper(outer->Contour)});
    for (const cl::PolyNode* const hole : outer->Childs) parts.back().push_back(from_clipper(hole->Contour));
    for (const cl::PolyNode* const hole : outer->Childs) take_parts(*hole, parts);
  }
}

}  // namespace

Polygon flattened(const Edges& path, double chord) {
  Polygon corners;
  for (const Edge& e : path) {
    int pieces = 1;
    if (!is_line(e)) {
      const double radius = circle_of(e).radius;
      const double step = 2 * std::acos(std::max(0.5, 1 - chord / radius));
      pieces = static_cast<int>(std::ceil(std::abs(4 * std::atan(e.bulge)) / step));
    }
    for (int i = 0; i < pieces; ++i) corners.push_back(at(e, double(i) / pieces));
  }
  if (!path.empty() && length(path.back().to - path.front().from) > 1 / per_mm) corners.push_back(path.back().to);
  return corners;
}

Polygons flattened(const std::vector<Edges>& loops, double chord) {
  Polygons all;
  for (const Edges& loop : loops) all.push_back(flattened(loop, chord));
  return all;
}

Polygons grown(const Polygons& areas, double by, double chord) {
  return by == 0 ? joined(areas, {}) : offset(areas, by, chord, cl::etClosedPolygon);
}

Polygons swept(const Polygons& lines, double radius, double chord, Ends ends) {
  return offset(lines, radius, chord, ends == Ends::round ? cl::etOpenRound : cl::etOpenButt);
}

Polygons joined(const Polygons& a, const Polygons& b) { return clip(cl::ctUnion, a, b); }
Polygons less(const Polygons& a, const Polygons& b) { return clip(cl::ctDifference, a, b); }
Polygons common(const Polygons& a, const Polygons& b) { return clip(cl::ctIntersection, a, b); }
Polygons lines_inside(const Polygons& lines, const Polygons& areas) { return clip_lines(cl::ctIntersection, lines, areas); }
Polygons lines_outside(const Polygons& lines, const Polygons& areas) { return clip_lines(cl::ctDifference, lines, areas); }

double area_of(const Polygons& areas) {
  double sum = 0;
  for (const Polygon& p : areas)
    for (std::size_t i = 0; i < p.size(); ++i) sum += cross(p[i] - p[0], p[(i + 1) % p.size()] - p[0]) / 2;
  return sum;
}

bool contains(const Polygons& areas, Vec2 p) {
  bool inside = false;
  for (const Polygon& polygon : areas)
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
      const Vec2 a = polygon[i], b = polygon[j];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
  return inside;
}

std::vector<Polygons> parts_of(const Polygons& areas) {
  cl::Clipper clipper;
  clipper.AddPaths(to_clipper(areas), cl::ptSubject, true);
  cl::PolyTree tree;
  clipper.Execute(cl::ctUnion, tree, cl::pftNonZero, cl::pftNonZero);
  std::vector<Polygons> parts;
  take_parts(tree, parts);
  return parts;
}

}  // namespace kadr::area
