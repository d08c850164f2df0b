// Measures the distance of one mesh from the triangles of another mesh. Used by stock/surface/simplified_surface.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include "base/thread.h"
#include "stock/part/nearest_triangle.h"
#include "stock/stock.h"
#include "stock/surface/simplified_surface.h"

namespace kadr {
namespace {

constexpr std::size_t triangles_a_share = 256;

/// Visits points of a triangle, including the corners, in rows along the longest side. Neighbouring points are at most `step` mm apart.
template <class Visit>
void each_place(const Mesh& mesh, std::size_t triangle, double step, const Visit& visit) {
  Vec3 p[3];
  for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.corner(triangle, k);
  while (length(p[1] - p[0]) < std::max(length(p[2] - p[1]), length(p[0] - p[2]))) std::rotate(p, p + 1, p + 3);
  const double longest = length(p[1] - p[0]);
  const double along_side =
      longest > 0
          ? ((p[2].x - p[0].x) * (p[1].x - p[0].x) + (p[2].y - p[0].y) * (p[1].y - p[0].y) + (p[2].z - p[0].z) * (p[1].z - p[0].z)) /
                longest
          : 0;
  const double side = length(p[2] - p[0]), height = std::sqrt(std::max(side * side - along_side * along_side, 0.0));
  const int rows = std::max(1, int(std::ceil(height / step)));
  for (int i = 0; i <= rows; ++i) {
    const double up = double(i) / rows;
    const Vec3 from = p[0] + up * (p[2] - p[0]), delta = p[1] + up * (p[2] - p[1]) - from;
    const int columns = std::max(1, int(std::ceil(length(delta) / step)));
    for (int j = 0; j <= columns; ++j) visit(from + double(j) / columns * delta);
  }
}

}  // namespace

double farthest_off(const Mesh& from, const Mesh& to, double step, const SimplifyRules& rules) {
  const NearestTriangle nearest(to, rules.threads);
  std::vector<double> most(std::size_t(rules.threads), 0);
  std::atomic<std::size_t> next{0};
  run_parallel(rules.threads, [&](int thread) {
    std::uint32_t hint = 0;
    double& own = most[std::size_t(thread)];
    for (std::size_t chunk; !rules.stop.requested() && (chunk = next++) * triangles_a_share < from.triangle_count();) {
      const std::size_t last = std::min((chunk + 1) * triangles_a_share, from.triangle_count());
      for (std::size_t t = chunk * triangles_a_share; t < last; ++t)
        each_place(from, t, step, [&](const Vec3& at) { own = std::max(own, nearest.distance(at, hint)); });
    }
  });
  return *std::max_element(most.begin(), most.end());
}

}  // namespace kadr
