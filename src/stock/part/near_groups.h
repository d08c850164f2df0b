#pragma once
// Orders triangles into groups of near ones. Used by stock/part/nearest_triangle.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"

namespace kadr {

/// Sizes of the groups: `smallest` triangles, then `times` as many, and so on.
struct GroupSizes {
  std::size_t smallest, times;
};

/// Returns the numbers of all triangles in an order in which each consecutive group of each size is compact: the triangles are halved
/// by their centres along the longest side, at the borders of groups.
std::vector<std::uint32_t> near_groups(const Mesh& mesh, GroupSizes sizes, int threads);

}  // namespace kadr
