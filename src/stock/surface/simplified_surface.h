#pragma once
// Computes a surface with fewer triangles whose distance from the exact surface is at most a given limit. Used by cli/cut.
//
//   exact ─ Decimation ─▶ simplified ─ distance measured in both directions ─▶ result, or another attempt with a smaller tolerance

#include "base/stop_token.h"
#include "stock/mesh/mesh.h"

namespace kadr {

struct SimplifyRules {
  double most_off = 0.01;  // greatest permitted distance between the exact and the simplified surface, mm
  int threads = 1;         // number of threads that measure the distance
  StopToken stop;
};

struct SimplifiedSurface {
  Mesh mesh;
  // Greatest distance in mm: of exact points from `mesh`, and of points of `mesh`, half a cell apart, from the exact surface.
  double off = 0;
};

/// Simplifies a surface. All points of the result are points of the exact surface.
///   exact    a closed mesh whose edges are each used by two triangles
///   returns  a mesh with the same properties
///   law      off ≤ most_off; the result is the same, bit for bit, for any number of threads   (tests/stock/simplify_test)
SimplifiedSurface simplified_surface(const Mesh& exact, const SimplifyRules& rules);

/// Returns an upper bound, in bytes, of the memory that simplification needs in addition to the exact surface.
double bytes_of_simplifying(std::size_t triangles);

/// Returns the greatest distance in mm of points of the mesh `from` to the mesh `to`. The points are the vertices of `from`, and points on
/// the triangles of `from` that are at most `step` mm apart.
double farthest_off(const Mesh& from, const Mesh& to, double step, const SimplifyRules& rules);

}  // namespace kadr
