// Simplifies a surface, measures its distance from the exact surface, and repeats with a smaller tolerance if this distance is too great.
// Used by cli/cut.

#include "stock/surface/simplified_surface.h"

#include <algorithm>
#include <cmath>

#include "stock/surface/decimation.h"

namespace kadr {
namespace {

// Fractions of the tolerance; each fraction is used for one simplification, so that flat regions are simplified first.
constexpr double shares_of_tolerance[] = {0.1, 0.35, 1};
constexpr int max_rounds = 4;
// Safety factor for the next tolerance, because the distance is only roughly proportional to the tolerance.
constexpr double of_found = 0.8;
constexpr double at_points = 1e9;  // step in mm that is larger than any triangle, so that only vertices are measured

/// Memory in bytes per triangle of the lists of Decimation and of its mesh; later, of the search trees of both surfaces.
constexpr double bytes_a_triangle = 180;

Mesh decimated(const Mesh& exact, double most_off, const StopToken& stop) {
  Decimation decimation(exact);
  for (const double share : shares_of_tolerance) decimation.go(share * most_off, stop);
  return decimation.mesh();
}

}  // namespace

SimplifiedSurface simplified_surface(const Mesh& exact, const SimplifyRules& rules) {
  const double half_a_cell = std::sqrt(area_of(exact) / double(std::max<std::size_t>(exact.triangle_count(), 1)) / 2);
  double allowed = rules.most_off;
  for (int round = 0; round < max_rounds && !exact.triangles.empty() && !rules.stop.requested(); ++round) {
    SimplifiedSurface simple{decimated(exact, allowed, rules.stop), 0};
    simple.off = std::max(farthest_off(exact, simple.mesh, at_points, rules), farthest_off(simple.mesh, exact, half_a_cell, rules));
    if (simple.off <= rules.most_off) return simple;
    allowed *= of_found * rules.most_off / simple.off;
  }
  return {exact, 0};
}

double bytes_of_simplifying(std::size_t triangles) { return double(triangles) * bytes_a_triangle; }

}  // namespace kadr
