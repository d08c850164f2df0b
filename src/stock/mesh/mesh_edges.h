#pragma once
// The edges of a mesh; they show whether it is closed and a manifold.

#include "stock/mesh/mesh.h"

namespace kadr {

/// One use of an edge by a triangle.
struct EdgeWay {
  std::uint64_t ends;  // numbers of the two points, the lower one in the upper half
  std::uint32_t triangle;
  bool upwards;  // from the lower to the higher point number
};

/// Returns the edge uses of all triangles, ordered by edge, then by triangle.
std::vector<EdgeWay> edge_ways(const Mesh& mesh);

/// Counts of faulty edges. A closed mesh uses each edge as often in one direction as in the other; a manifold uses it once in each.
struct MeshEdges {
  std::size_t open = 0;           // uses of an edge without a use in the opposite direction
  std::size_t doubled = 0;        // repeated uses of an edge in the same direction
  std::size_t open_triangle = 0;  // the first triangle with an open edge; the number of triangles if there is none
};
MeshEdges edges_of(const Mesh& mesh);

}  // namespace kadr
