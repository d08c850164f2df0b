#pragma once
// Merges points of a mesh that are equal or close to each other. Used by stock/mesh/mesh_repair.

#include "stock/mesh/mesh.h"

namespace kadr {

/// Merges points with equal coordinates. The remaining points keep their order.
void weld_equal(Mesh& mesh);

/// Merges each marked point into the first marked point within `tolerance` mm.
///   returns  the number of points that were merged into another point
std::size_t weld_near(Mesh& mesh, const std::vector<bool>& marked, double tolerance);

/// Removes triangles with two equal corners, and the corresponding elements of `numbers`, which has one element per triangle.
void drop_flat(Mesh& mesh, std::vector<std::uint32_t>& numbers);

/// Removes points that belong to no triangle.
void drop_unused(Mesh& mesh);

}  // namespace kadr
