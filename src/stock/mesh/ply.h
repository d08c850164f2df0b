#pragma once
// PLY: a mesh whose points carry a number and a colour, as MeshLab, CloudCompare and Blender open it.

#include <cstdint>
#include <functional>
#include <vector>

#include "stock/mesh/byte_sink.h"
#include "stock/mesh/mesh.h"

namespace kadr {

/// 0xRRGGBB.
using ColourOf = std::function<std::uint32_t(float)>;

/// Binary, little endian; of each vertex x, y, z, its colour, and `deviation`. The same bytes for the same mesh.
///   deviation  mm, one a point
///   returns    false: the sink did not take all
bool write_ply(const Mesh& mesh, const std::vector<float>& deviation, const ColourOf& colour, const ByteSink& sink);

}  // namespace kadr
