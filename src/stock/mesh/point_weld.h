#pragma once
// Points of a mesh at the same place, or nearly, become one. For stock/mesh/mesh_repair.

#include "stock/mesh/mesh.h"

namespace kadr {

/// Points with the same coordinates are one; the others keep their order.
void weld_equal(Mesh& mesh);

/// Of the points that are marked each takes the number of the first marked one within `tolerance` mm.
///   returns  how many were joined to another
std::size_t weld_near(Mesh& mesh, const std::vector<bool>& marked, double tolerance);

/// Triangles two of whose corners are one point go; so does their number in `numbers`, which has one for each.
void drop_flat(Mesh& mesh, std::vector<std::uint32_t>& numbers);

/// Points that no triangle has go.
void drop_unused(Mesh& mesh);

}  // namespace kadr
