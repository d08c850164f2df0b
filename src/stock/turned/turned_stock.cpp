// Cuts a spinning part in its half plane. Used by session/cutting; tested by tests/stock/turned_stock_test.cpp.

#include "stock/turned/turned_stock.h"

#include <algorithm>
#include <clipper.hpp>
#include <cmath>
#include <numbers>

#include "stock/turned/edge_distance.h"

namespace kadr {

namespace cl = ClipperLib;

constexpr cl::cInt farthest_nm = 100'000'000'000;  // nm; no coordinate is greater

/// A rectangle in nm. `least` and `most` of an empty rectangle are exchanged.
struct TurnedBounds {
  cl::IntPoint least{farthest_nm, farthest_nm}, most{-farthest_nm, -farthest_nm};

  void include(const cl::IntPoint& p) {
    least = {std::min(least.X, p.X), std::min(least.Y, p.Y)};
    most = {std::max(most.X, p.X), std::max(most.Y, p.Y)};
  }
  bool meets(const TurnedBounds& b) const { return least.X < b.most.X && b.least.X < most.X && least.Y < b.most.Y && b.least.Y < most.Y; }
  cl::Path path() const { return {least, {most.X, least.Y}, most, {least.X, most.Y}}; }
};

namespace {

constexpr double per_mm = 1e6;            // units of Clipper per mm: a unit is a nanometre
constexpr std::size_t most_corners = 64;  // a rectangle with more corners is halved
constexpr cl::cInt least_side = 100'000;  // nm; a rectangle whose longer side is shorter than this is not halved
constexpr double noise = 1.415;           // nm; corners that rounding to whole nanometres adds deviate by less than this
constexpr double least_corner = 10;       // nm; corners of region() deviate by more than this
constexpr double thinnest = 5;            // nm; a hole that is thinner is a gap between rectangles
constexpr double on_blank = 1e-5;         // mm; a point this near to the surface of the blank lies on it

cl::Path path_of(const TurnedPolygon& polygon) {
  cl::Path path;
  path.reserve(polygon.size());
  for (const Vec2 p : polygon) path.emplace_back(std::llround(p.x * per_mm), std::llround(p.y * per_mm));
  return path;
}

TurnedPolygon polygon_of(const cl::Path& path) {
  TurnedPolygon polygon;
  polygon.reserve(path.size());
  for (const cl::IntPoint& p : path) polygon.push_back({double(p.X) / per_mm, double(p.Y) / per_mm});
  return polygon;
}

TurnedBounds bounds_of(const cl::Paths& paths) {
  TurnedBounds bounds;
  for (const cl::Path& path : paths)
    for (const cl::IntPoint& p : path) bounds.include(p);
  return bounds;
}

cl::Paths clipped(cl::ClipType type, const cl::Paths& subject, const cl::Path& clip) {
  cl::Clipper clipper;
  clipper.AddPaths(subject, cl::ptSubject, true);
  clipper.AddPath(clip, cl::ptClip, true);
  cl::Paths result;
  clipper.Execute(type, result, cl::pftNonZero, cl::pftNonZero);
  return result;
}

/// Cuts a convex path off along one side of a rectangle. `axis`: 0 for X, 1 for Y; what lies beyond `limit` is removed: above it if `sense`
/// is 1, below it if -1.
cl::Path cut_off(const cl::Path& path, int axis, cl::cInt limit, int sense) {
  const auto inside = [&](const cl::IntPoint& p) { return sense * ((axis == 0 ? p.X : p.Y) - limit) <= 0; };
  cl::Path kept;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const cl::IntPoint &a = path[i], &b = path[(i + 1) % path.size()];
    if (inside(a)) kept.push_back(a);
    if (inside(a) == inside(b)) continue;
    const double along = axis == 0 ? double(limit - a.X) / double(b.X - a.X) : double(limit - a.Y) / double(b.Y - a.Y);
    if (axis == 0) kept.emplace_back(limit, a.Y + std::llround(along * double(b.Y - a.Y)));
    else kept.emplace_back(a.X + std::llround(along * double(b.X - a.X)), limit);
  }
  return kept;
}

/// Returns the part of a convex path in and around a rectangle: Clipper is given few corners. Its edges in the rectangle are those of the
/// path, within a nanometre.
cl::Path near_part(const cl::Path& path, const TurnedBounds& reach, const TurnedBounds& of) {
  constexpr cl::cInt room = 1000;  // nm
  cl::Path part = path;
  if (reach.least.X < of.least.X - room) part = cut_off(part, 0, of.least.X - room, -1);
  if (reach.most.X > of.most.X + room) part = cut_off(part, 0, of.most.X + room, 1);
  if (reach.least.Y < of.least.Y - room) part = cut_off(part, 1, of.least.Y - room, -1);
  if (reach.most.Y > of.most.Y + room) part = cut_off(part, 1, of.most.Y + room, 1);
  return part;
}

/// Returns 2 π ∫ r dA in mm³, positive for a counter-clockwise path.
double volume_of_path(const cl::Path& path) {
  double sum = 0;
  if (path.empty()) return sum;
  const double z0 = double(path[0].Y);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const cl::IntPoint &a = path[i], &b = path[(i + 1) % path.size()];
    const double ar = double(a.X), br = double(b.X), az = double(a.Y) - z0, bz = double(b.Y) - z0;
    sum += (ar + br) * (ar * bz - br * az);
  }
  return sum * std::numbers::pi / 3 / (per_mm * per_mm * per_mm);
}

double volume_of_paths(const cl::Paths& paths) {
  double sum = 0;
  for (const cl::Path& path : paths) sum += volume_of_path(path);
  return sum;
}

std::size_t corners_of(const cl::Paths& paths) {
  std::size_t count = 0;
  for (const cl::Path& path : paths) count += path.size();
  return count;
}

/// Returns true if the middle of the edge lies on the surface of the blank, along an edge of it.
bool is_of_blank(Vec2 a, Vec2 b, const TurnedRegion& blank) {
  const Vec2 middle = 0.5 * (a + b);
  for (const TurnedPolygon& polygon : blank)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 c = polygon[i], d = polygon[(i + 1) % polygon.size()];
      if (distance_to_edge(middle, c, d) < on_blank && std::fabs(cross(b - a, d - c)) <= 1e-3 * length(b - a) * length(d - c)) return true;
    }
  return false;
}

/// True if the path is a gap of a few nanometres between rectangles, or a chip that thin.
bool is_gap(const cl::Path& path) {
  double around = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const cl::IntPoint &a = path[i], &b = path[(i + 1) % path.size()];
    around += std::hypot(double(b.X - a.X), double(b.Y - a.Y));
  }
  return 2 * std::fabs(cl::Area(path)) <= thinnest * around;
}

}  // namespace

/// A rectangle of the half plane: the material in it, or the two halves into which it is divided.
struct TurnedStock::Cell {
  TurnedBounds place;     // the rectangle
  cl::Paths paths;        // the material, if the rectangle is not divided
  TurnedBounds material;  // the box around the material; of a divided rectangle also what its halves have lost since
  double volume = 0;
  std::unique_ptr<Cell> halves[2];

  void set(cl::Paths&& now) {
    paths = std::move(now);
    material = bounds_of(paths);
    volume = volume_of_paths(paths);
  }

  /// Halves the rectangle, again and again, until no part has too many corners.
  void divide() {
    const cl::cInt wide = place.most.X - place.least.X, tall = place.most.Y - place.least.Y;
    if (corners_of(paths) <= most_corners || std::max(wide, tall) < least_side) return;
    TurnedBounds low = place, high = place;
    if (wide > tall) low.most.X = high.least.X = place.least.X + wide / 2;
    else low.most.Y = high.least.Y = place.least.Y + tall / 2;
    for (int i = 0; i < 2; ++i) {
      halves[i] = std::make_unique<Cell>();
      halves[i]->place = i == 0 ? low : high;
      halves[i]->set(clipped(cl::ctIntersection, paths, halves[i]->place.path()));
      halves[i]->divide();
    }
    paths = {};
  }

  double remove(const cl::Path& swept, const TurnedBounds& reach) {
    if (!material.meets(reach)) return 0;
    if (halves[0]) {
      const double removed = halves[0]->remove(swept, reach) + halves[1]->remove(swept, reach);
      volume -= removed;
      return removed;
    }
    const double before = volume;
    const cl::Path part = near_part(swept, reach, material);
    if (part.size() < 3) return 0;
    cl::Paths left = clipped(cl::ctDifference, paths, part);
    cl::CleanPolygons(left, noise);
    std::erase_if(left, [](const cl::Path& path) { return path.size() < 3; });
    set(std::move(left));
    const double removed = before - volume;
    divide();
    return removed;
  }

  void touch(const cl::Path& swept, const TurnedBounds& reach, double& met, TurnedBounds& box) const {
    if (!material.meets(reach)) return;
    for (const auto& half : halves)
      if (half) half->touch(swept, reach, met, box);
    if (halves[0]) return;
    const cl::Paths common = clipped(cl::ctIntersection, paths, near_part(swept, reach, material));
    met += volume_of_paths(common);
    for (const cl::Path& path : common)
      for (const cl::IntPoint& p : path) box.include(p);
  }

  double left() const { return halves[0] ? halves[0]->left() + halves[1]->left() : volume; }

  void collect(cl::Paths& all) const {
    for (const auto& half : halves)
      if (half) half->collect(all);
    all.insert(all.end(), paths.begin(), paths.end());
  }
};

namespace {

/// Calls visit(path, bounds) with the part of a swept area above the axis, and with the mirror image of the part below.
template <class Visit>
void each_side(const TurnedPolygon& swept, const Visit& visit) {
  cl::Path path = path_of(swept);
  const TurnedBounds reach = bounds_of({path});
  if (reach.most.X > 0) visit(path, reach);
  if (reach.least.X >= 0) return;
  std::reverse(path.begin(), path.end());
  for (cl::IntPoint& p : path) p.X = -p.X;
  visit(path, bounds_of({path}));
}

}  // namespace

TurnedRegion cylinder_region(double bottom, double top, double diameter, double bore) {
  const double inner = bore / 2, outer = diameter / 2;
  return {{{inner, bottom}, {outer, bottom}, {outer, top}, {inner, top}}};
}

double volume_of(const TurnedRegion& region) {
  double sum = 0;
  for (const TurnedPolygon& polygon : region) sum += volume_of_path(path_of(polygon));
  return sum;
}

double TurnedTouch::depth() const { return std::min(most.x - least.x, most.y - least.y); }

TurnedStock::TurnedStock(TurnedRegion blank) : blank_(std::move(blank)), root_(std::make_unique<Cell>()) {
  cl::Paths paths;
  for (const TurnedPolygon& polygon : blank_) paths.push_back(path_of(polygon));
  TurnedBounds upper{{0, -farthest_nm}, {farthest_nm, farthest_nm}};
  root_->set(clipped(cl::ctIntersection, paths, upper.path()));
  root_->place = root_->material;
  root_->divide();
}

TurnedStock::TurnedStock(TurnedStock&&) noexcept = default;
TurnedStock::~TurnedStock() = default;

TurnedTouch TurnedStock::remove(const TurnedPolygon& swept, bool with_box) {
  TurnedTouch touched = with_box ? touch(swept) : TurnedTouch();
  touched.volume = 0;
  each_side(swept, [&](const cl::Path& path, const TurnedBounds& reach) { touched.volume += root_->remove(path, reach); });
  return touched;
}

TurnedTouch TurnedStock::touch(const TurnedPolygon& swept) const {
  TurnedTouch touched;
  TurnedBounds box;
  each_side(swept, [&](const cl::Path& path, const TurnedBounds& reach) { root_->touch(path, reach, touched.volume, box); });
  if (box.least.X > box.most.X) return touched;
  touched.least = {double(box.least.X) / per_mm, double(box.least.Y) / per_mm};
  touched.most = {double(box.most.X) / per_mm, double(box.most.Y) / per_mm};
  return touched;
}

double TurnedStock::volume() const { return root_->left(); }
double TurnedStock::blank_volume() const { return volume_of(blank_); }

TurnedRegion TurnedStock::region() const {
  cl::Paths all;
  root_->collect(all);
  cl::Clipper clipper;
  clipper.AddPaths(all, cl::ptSubject, true);
  cl::Paths joined;
  clipper.Execute(cl::ctUnion, joined, cl::pftNonZero, cl::pftNonZero);
  cl::CleanPolygons(joined, least_corner);
  TurnedRegion region;
  for (const cl::Path& path : joined)
    if (path.size() >= 3 && !is_gap(path)) region.push_back(polygon_of(path));
  return region;
}

TurnedStock::Area TurnedStock::area() const {
  Area sum;
  for (const TurnedPolygon& polygon : region())
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      const double cone = std::numbers::pi * (a.x + b.x) * length(b - a);
      if (!(cone > 0)) continue;
      sum.whole += cone;
      if (!is_of_blank(a, b, blank_)) sum.machined += cone;
    }
  return sum;
}

std::optional<Vec2> TurnedStock::radii_at(double z) const {
  std::optional<Vec2> radii;
  for (const TurnedPolygon& polygon : region())
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if ((a.y > z) == (b.y > z)) continue;
      const double radius = a.x + (b.x - a.x) * (z - a.y) / (b.y - a.y);
      radii = radii ? Vec2{std::min(radii->x, radius), std::max(radii->y, radius)} : Vec2{radius, radius};
    }
  return radii;
}

}  // namespace kadr
