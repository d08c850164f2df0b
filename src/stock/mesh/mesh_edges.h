#pragma once
// Lists the edges of a mesh, which show whether the mesh is closed and a manifold.

#include "stock/mesh/mesh.h"

namespace kadr {

/// The use of an edge by one triangle.
struct EdgeUse {
  std::uint64_t ends;  // numbers of the two end points; the lower number is in the upper 32 bits
  std::uint32_t triangle;
  bool upwards;  // true if the triangle uses the edge from the lower to the higher point number
};

/// Returns the edge uses of all triangles, sorted by edge, then by triangle.
std::vector<EdgeUse> edge_uses(const Mesh& mesh);

/// Numbers of faulty edges. A closed mesh uses each edge as often in one direction as in the other; a manifold uses each edge once in each
/// direction.
struct MeshEdges {
  std::size_t open = 0;           // number of edge uses without a use in the opposite direction
  std::size_t doubled = 0;        // number of repeated uses of an edge in the same direction
  std::size_t open_triangle = 0;  // number of the first triangle with an open edge; the number of all triangles if no edge is open
};
MeshEdges edges_of(const Mesh& mesh);

}  // namespace kadr
