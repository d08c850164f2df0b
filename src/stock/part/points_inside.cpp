// Sorts the points into squares of the XY plane, and then tests each triangle against the points above or below it. Used by
// stock/part/part_compare.

#include "stock/part/points_inside.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/thread.h"
#include "stock/mesh/triangle_across.h"
#include "stock/stock.h"

namespace kadr {
namespace {

constexpr double points_of_square = 2;
constexpr std::size_t triangles_at_once_inside = 4096;

/// A point, and two sums of MeshHit::turn over the triangles that the vertical line through the point meets: below the point, and exactly
/// at the point. The sums do not depend on the order of the triangles.
struct HeldPoint {
  float x, y, z;
  std::uint32_t number;
  std::int32_t below = 0, at = 0;
};

/// The squares of the XY plane in rows along X, and the points in each square.
struct PointSquares {
  double least_x = 0, least_y = 0, most_x = 0, most_y = 0, per_mm = 0;
  std::size_t columns = 1, rows = 1;
  std::vector<std::uint32_t> first;  // index in `points` of the first point of each square; the last element is the number of all points
  std::vector<HeldPoint> points;

  explicit PointSquares(const std::vector<float>& places);
  static std::size_t at(double place, double least, double per, std::size_t count) {
    return std::size_t(std::clamp((place - least) * per, 0.0, double(count - 1)));
  }
  std::size_t column(double x) const { return at(x, least_x, per_mm, columns); }
  std::size_t row(double y) const { return at(y, least_y, per_mm, rows); }
  void hold(const Mesh& solid, std::size_t triangle);
  void hold(const TriangleAcross& triangle, HeldPoint* from, HeldPoint* to);
};

PointSquares::PointSquares(const std::vector<float>& places) {
  const std::size_t count = places.size() / 3;
  float low[2] = {places[0], places[1]}, high[2] = {places[0], places[1]};
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t d = 0; d < 2; ++d) low[d] = std::min(low[d], places[3 * i + d]), high[d] = std::max(high[d], places[3 * i + d]);
  least_x = double(low[0]), least_y = double(low[1]), most_x = double(high[0]), most_y = double(high[1]);
  const double wide = most_x - least_x, deep = most_y - least_y, squares = double(count) / points_of_square;
  // In a narrow strip, the number of squares along the strip is limited to the number of points.
  const double edge = std::max({std::sqrt(wide * deep / squares), wide / squares, deep / squares, 1e-6});
  per_mm = 1 / edge;
  columns = std::size_t(wide * per_mm) + 1, rows = std::size_t(deep * per_mm) + 1;
  first.assign(columns * rows + 1, 0);
  const auto square = [&](std::size_t i) { return row(double(places[3 * i + 1])) * columns + column(double(places[3 * i])); };
  for (std::size_t i = 0; i < count; ++i) ++first[square(i) + 1];
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  points.resize(count);
  for (std::size_t i = count; i-- > 0;)
    points[--first[square(i) + 1]] = {places[3 * i], places[3 * i + 1], places[3 * i + 2], std::uint32_t(i)};
  // Element i + 1 of `first` is now the index of the first point in square i, so the first element is removed.
  first.erase(first.begin());
  first.push_back(std::uint32_t(count));
}

void PointSquares::hold(const TriangleAcross& triangle, HeldPoint* from, HeldPoint* to) {
  const double low_x = triangle.least_u(), high_x = triangle.most_u(), low_y = triangle.least_v(), high_y = triangle.most_v();
  TriangleRow across;
  for (HeldPoint* p = from; p != to; ++p) {
    const double x = double(p->x), y = double(p->y);
    if (x < low_x || x >= high_x || y < low_y || y >= high_y) continue;
    if (!triangle.row(y, across) || !across.holds(x)) continue;
    const double place = across.place(x), z = double(p->z);
    if (place > z) continue;
    std::atomic_ref<std::int32_t>(place < z ? p->below : p->at).fetch_add(across.turn, std::memory_order_relaxed);
  }
}

void PointSquares::hold(const Mesh& solid, std::size_t number) {
  const TriangleAcross triangle(solid, number, 2);
  if (triangle.most_u() < least_x || triangle.least_u() > most_x || triangle.most_v() < least_y || triangle.least_v() > most_y) return;
  const std::size_t low = row(triangle.least_v()), high = row(triangle.most_v());
  for (std::size_t r = low; r <= high; ++r) {
    double left = triangle.least_u(), right = triangle.most_u();
    // Of a long slanted triangle, only the extent over this row of squares is used, with a small margin.
    if (low < high && right - left > 1 / per_mm) {
      const double hair = 1e-3 / per_mm, begin = least_y + double(r) / per_mm, end = begin + 1 / per_mm;
      const auto extent = triangle.between(r == low ? triangle.least_v() : begin - hair, r == high ? triangle.most_v() : end + hair);
      left = extent[0] - hair, right = extent[1] + hair;
    }
    const std::size_t square = r * columns, a = column(left), b = column(right);
    hold(triangle, points.data() + first[square + a], points.data() + first[square + b + 1]);
  }
}

}  // namespace

std::vector<std::uint8_t> points_inside(const Mesh& solid, const std::vector<float>& places, int threads) {
  std::vector<std::uint8_t> inside(places.size() / 3);
  if (places.empty()) return inside;
  PointSquares squares(places);
  std::atomic<std::size_t> next{0};
  run_parallel(threads, [&](int) {
    for (std::size_t i; (i = triangles_at_once_inside * next++) < solid.triangle_count();)
      for (std::size_t t = i; t < std::min(i + triangles_at_once_inside, solid.triangle_count()); ++t) squares.hold(solid, t);
  });
  for (const HeldPoint& p : squares.points) inside[p.number] = p.below > 0 && p.below + p.at > 0;
  return inside;
}

}  // namespace kadr
