// Edges sorted by their ends. For stock/mesh/mesh_repair and tests.

#include "stock/mesh/mesh_edges.h"

#include <algorithm>

namespace kadr {

std::vector<EdgeWay> edge_ways(const Mesh& mesh) {
  std::vector<EdgeWay> ways;
  ways.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[3 * t + k], b = mesh.triangles[3 * t + (k + 1) % 3];
      ways.push_back({std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), std::uint32_t(t), a < b});
    }
  std::sort(ways.begin(), ways.end(),
            [](const EdgeWay& a, const EdgeWay& b) { return a.ends != b.ends ? a.ends < b.ends : a.triangle < b.triangle; });
  return ways;
}

MeshEdges edges_of(const Mesh& mesh) {
  const std::vector<EdgeWay> ways = edge_ways(mesh);
  MeshEdges edges;
  edges.open_triangle = mesh.triangle_count();
  for (std::size_t i = 0; i < ways.size();) {
    std::size_t up = 0, down = 0, end = i;
    for (; end < ways.size() && ways[end].ends == ways[i].ends; ++end) ++(ways[end].upwards ? up : down);
    edges.open += up > down ? up - down : down - up;
    edges.doubled += (up > 1 ? up - 1 : 0) + (down > 1 ? down - 1 : 0);
    if (up != down) edges.open_triangle = std::min<std::size_t>(edges.open_triangle, ways[i].triangle);
    i = end;
  }
  return edges;
}

}  // namespace kadr
