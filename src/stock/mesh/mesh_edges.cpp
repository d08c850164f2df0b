// Lists the edges of a mesh, sorted by the numbers of their end points, so that all uses of an edge are consecutive. Used by
// stock/mesh/mesh_repair and tests.

#include "stock/mesh/mesh_edges.h"

#include <algorithm>

namespace kadr {

std::vector<EdgeUse> edge_uses(const Mesh& mesh) {
  const auto each = [&](const auto& visit) {
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
      for (std::size_t k = 0; k < 3; ++k) visit(t, mesh.triangles[3 * t + k], mesh.triangles[3 * t + (k + 1) % 3]);
  };
  // A counting sort by the lower point number comes first; each group then has only a few edges, which std::sort orders.
  std::vector<std::size_t> next(mesh.point_count() + 1, 0);
  each([&](std::size_t, std::uint32_t a, std::uint32_t b) { ++next[std::size_t(std::min(a, b)) + 1]; });
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  std::vector<EdgeUse> uses(mesh.triangles.size());
  each([&](std::size_t t, std::uint32_t a, std::uint32_t b) {
    uses[next[std::min(a, b)]++] = {std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), std::uint32_t(t), a < b};
  });
  for (std::size_t point = 0; point + 1 < next.size(); ++point)
    std::sort(uses.begin() + std::ptrdiff_t(point == 0 ? 0 : next[point - 1]), uses.begin() + std::ptrdiff_t(next[point]),
              [](const EdgeUse& a, const EdgeUse& b) { return a.ends != b.ends ? a.ends < b.ends : a.triangle < b.triangle; });
  return uses;
}

MeshEdges edges_of(const Mesh& mesh) {
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  MeshEdges edges;
  edges.open_triangle = mesh.triangle_count();
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t up = 0, down = 0, end = i;
    for (; end < uses.size() && uses[end].ends == uses[i].ends; ++end) ++(uses[end].upwards ? up : down);
    edges.open += up > down ? up - down : down - up;
    edges.doubled += (up > 1 ? up - 1 : 0) + (down > 1 ? down - 1 : 0);
    if (up != down) edges.open_triangle = std::min<std::size_t>(edges.open_triangle, uses[i].triangle);
    i = end;
  }
  return edges;
}

}  // namespace kadr
