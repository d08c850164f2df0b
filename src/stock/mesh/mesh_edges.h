#pragma once
// The edges of a mesh: is it closed, is it a manifold?

#include "stock/mesh/mesh.h"

namespace kadr {

/// A triangle goes along an edge.
struct EdgeWay {
  std::uint64_t ends;  // the lower point in the upper half
  std::uint32_t triangle;
  bool upwards;  // from the lower point
};

/// Of all triangles; by edges, then by triangles.
std::vector<EdgeWay> edge_ways(const Mesh& mesh);

/// Edges of a closed mesh are each gone along as often one way as the other; those of a manifold once each way.
struct MeshEdges {
  std::size_t open = 0;           // ways along an edge that no triangle goes back
  std::size_t doubled = 0;        // that go where another has gone
  std::size_t open_triangle = 0;  // the first with an open edge; as many as there are: none
};
MeshEdges edges_of(const Mesh& mesh);

}  // namespace kadr
