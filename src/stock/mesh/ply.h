#pragma once
// PLY: writes a mesh whose points have a number and a colour. MeshLab, CloudCompare and Blender can read such a file.

#include <cstdint>
#include <functional>
#include <vector>

#include "stock/mesh/byte_sink.h"
#include "stock/mesh/mesh.h"

namespace kadr {

/// A function that returns the colour of a deviation (mm) as 0xRRGGBB.
using ColourOf = std::function<std::uint32_t(float)>;

/// Writes binary little-endian PLY with x, y, z, colour and `deviation` of each point. The same mesh always gives the same bytes.
///   deviation  one number in mm for each point
///   returns    false if the sink refused bytes; the file is then incomplete
bool write_ply(const Mesh& mesh, const std::vector<float>& deviation, const ColourOf& colour, const ByteSink& sink);

}  // namespace kadr
