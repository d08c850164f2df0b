#pragma once
// Sorts triangles so that triangles close to each other form groups. Used by stock/part/nearest_triangle.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"

namespace kadr {

/// Sizes of the groups in triangles: the smallest size is `smallest`, and each next size is `times` as large.
struct GroupSizes {
  std::size_t smallest, times;
};

/// Returns the numbers of all triangles, sorted so that consecutive groups of each size are compact. The list is halved recursively: the
/// centres of the triangles are divided along the longest edge of their box, each time at the border between two groups.
std::vector<std::uint32_t> near_groups(const Mesh& mesh, GroupSizes sizes, int threads);

}  // namespace kadr
