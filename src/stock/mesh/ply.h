#pragma once
// PLY: writes a mesh whose points have a number and a colour. MeshLab, CloudCompare and Blender can read it.

#include <cstdint>
#include <functional>
#include <vector>

#include "stock/mesh/byte_sink.h"
#include "stock/mesh/mesh.h"

namespace kadr {

/// Must return the colour of a deviation (mm) as 0xRRGGBB.
using ColourOf = std::function<std::uint32_t(float)>;

/// Writes binary little-endian PLY with x, y, z, colour and `deviation` of each point. The same mesh always gives the same bytes.
///   deviation  mm, one per point
///   returns    false if the sink did not accept everything
bool write_ply(const Mesh& mesh, const std::vector<float>& deviation, const ColourOf& colour, const ByteSink& sink);

}  // namespace kadr
