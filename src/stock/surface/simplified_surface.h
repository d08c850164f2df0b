#pragma once
// A surface with fewer triangles, within a permitted distance of the exact one. Used by cli/cut.
//
//   exact ─ Decimation ─▶ simple ─ measured in both directions by the tree of triangles ─▶ near enough, or repeated with less
//   tolerance

#include "base/stop.h"
#include "stock/mesh/mesh.h"

namespace kadr {

struct SimplifyRules {
  double most_off = 0.01;  // mm
  int threads = 1;         // for measuring
  StopToken stop;
};

struct SimplifiedSurface {
  Mesh mesh;
  double off = 0;  // mm, the greatest distance: of exact points from this mesh, and of its points, half a cell apart, from the exact one
};

/// Simplifies a surface. The points of the result are points of the exact surface.
///   exact    closed, without doubled edges
///   returns  a mesh that is closed too, without doubled edges
///   law      off ≤ most_off; the same bits for any number of threads   (tests/stock/simplify_test)
SimplifiedSurface simplified_surface(const Mesh& exact, const SimplifyRules& rules);

/// Upper bound of the memory needed besides the exact surface.
double bytes_of_simplifying(std::size_t triangles);

/// Returns the greatest distance from mesh `to` of points of mesh `from`: its vertices, and points at most `step` apart.
double farthest_off(const Mesh& from, const Mesh& to, double step, const SimplifyRules& rules);

}  // namespace kadr
