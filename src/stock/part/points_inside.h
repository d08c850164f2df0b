#pragma once
// Finds out which of many points are inside a solid. Used by stock/part/part_compare.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"

namespace kadr {

/// A point counts as inside if the vertical line through the point is inside the solid both just below and just above the point.
///   points   x, y, z of each point, mm
///   returns  for each point 1 if it is inside, else 0
///   law      bit for bit equal to mesh_blank(solid)->cross()   (tests/stock/part_lines_test)
///   memory   29 bytes per point, of which the result takes one
std::vector<std::uint8_t> points_inside(const Mesh& solid, const std::vector<float>& points, int threads);

}  // namespace kadr
