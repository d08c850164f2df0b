#pragma once
// Which of many points lie inside a solid. For stock/part/part_compare.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"

namespace kadr {

/// A point lies inside where the upright line through it, in the direction of Z, is inside the solid below it and above it.
///   points   x, y, z of each, mm
///   returns  1 for each that is, else 0
///   law      as mesh_blank(solid)->cross() says, to the bit   (tests/stock/part_lines_test)
///   memory   29 bytes a point, of which one is handed back
std::vector<std::uint8_t> points_inside(const Mesh& solid, const std::vector<float>& points, int threads);

}  // namespace kadr
