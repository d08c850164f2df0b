#pragma once
// Lists the edges of a mesh, which show whether the mesh is closed and a manifold.

#include "stock/mesh/mesh.h"

namespace kadr {

/// The use of an edge by one triangle.
struct EdgeUse {
  std::uint64_t ends;  // numbers of the two points, the lower number in the upper 32 bits
  std::uint32_t triangle;
  bool upwards;  // the triangle uses the edge from the lower to the higher point number
};

/// Returns the edge uses of all triangles, sorted by edge, then by triangle.
std::vector<EdgeUse> edge_uses(const Mesh& mesh);

/// Counts of faulty edges. A closed mesh uses each edge as often in one direction as in the other; a manifold uses it once in each.
struct MeshEdges {
  std::size_t open = 0;           // number of edge uses without a use in the opposite direction
  std::size_t doubled = 0;        // number of repeated uses of an edge in the same direction
  std::size_t open_triangle = 0;  // number of the first triangle with an open edge; the count of all triangles if there is none
};
MeshEdges edges_of(const Mesh& mesh);

}  // namespace kadr
