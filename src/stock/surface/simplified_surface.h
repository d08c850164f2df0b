#pragma once
// A surface with fewer triangles, which is off by no more than was allowed. For cli/cut.
//
//   exact ─ Decimation ─▶ simple ─ measured both ways by the tree of triangles ─▶ near enough, or once more with less allowed

#include "base/stop.h"
#include "stock/mesh/mesh.h"

namespace kadr {

struct SimplifyRules {
  double most_off = 0.01;  // mm
  int threads = 1;         // that measure
  StopToken stop;
};

struct SimplifiedSurface {
  Mesh mesh;
  double off = 0;  // mm, the farthest: of the exact surface's points from this one, of places of this one, half a cell apart, from that
};

/// Its points are points of the exact surface.
///   exact    closed, no edge doubled
///   returns  so is this
///   law      off ≤ most_off; the same bits for any number of threads   (tests/stock/simplify_test)
SimplifiedSurface simplified_surface(const Mesh& exact, const SimplifyRules& rules);

/// That it takes besides the exact surface, at most.
double bytes_of_simplifying(std::size_t triangles);

/// The greatest distance of the places of one mesh, its points among them and others at most `step` apart, from another.
double farthest_off(const Mesh& from, const Mesh& to, double step, const SimplifyRules& rules);

}  // namespace kadr
