#pragma once
// Finds out which of many given points are inside a solid. Used by stock/part/part_compare.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"

namespace kadr {

/// A point counts as inside if the vertical line through the point is inside the solid both just below and just above the point.
///   points   x, y, z of each point, mm
///   returns  for each point 1 if the point is inside the solid, else 0
///   law      the result agrees with mesh_blank(solid)->cross(), bit for bit   (tests/stock/part_lines_test)
///   memory   29 bytes per point, including one byte for the result
std::vector<std::uint8_t> points_inside(const Mesh& solid, const std::vector<float>& points, int threads);

}  // namespace kadr
