#pragma once
// Sorts triangles so that triangles near each other form groups. Used by stock/part/nearest_triangle.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"

namespace kadr {

/// Sizes of the groups: `smallest` triangles, then `times` as many, then `times` as many again, and so on.
struct GroupSizes {
  std::size_t smallest, times;
};

/// Returns the numbers of all triangles, sorted so that consecutive groups of each size are compact. The list is halved recursively by
/// the centres of the triangles along the longest side of their box; each cut is at the border between two groups.
std::vector<std::uint32_t> near_groups(const Mesh& mesh, GroupSizes sizes, int threads);

}  // namespace kadr
