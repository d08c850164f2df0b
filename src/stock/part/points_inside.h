#pragma once
// Finds which of many points are inside a solid. Used by stock/part/part_compare.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"

namespace kadr {

/// A point is inside if the vertical line through it is inside the solid both just below and just above it.
///   points   x, y, z of each, mm
///   returns  1 for each point inside, else 0
///   law      equal to mesh_blank(solid)->cross() to the bit   (tests/stock/part_lines_test)
///   memory   29 bytes per point, one of which is returned
std::vector<std::uint8_t> points_inside(const Mesh& solid, const std::vector<float>& points, int threads);

}  // namespace kadr
