#pragma once
// Triangles in groups that lie near each other. For stock/part/nearest_triangle.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"

namespace kadr {

/// Sizes of groups: `smallest` triangles, `times` as many, and so on.
struct GroupSizes {
  std::size_t smallest, times;
};

/// Numbers of all triangles in such an order that each group in a row, of each size, lies close together: by their middles halved along the
/// longest side, at the borders of groups.
std::vector<std::uint32_t> near_groups(const Mesh& mesh, GroupSizes sizes, int threads);

}  // namespace kadr
