#pragma once
// The outline of a tool for drawings: the shape that the cutting simulation uses.

#include <vector>

#include "config/tool_geometry.h"

namespace kadr {

/// Returns cutting part, shank and holder from the tip upwards, with round ends as short straight pieces; empty for a turning tool
/// and for a tool without a shape.
///   law  no height is below the one before
std::vector<ProfilePoint> outline_of(const ToolGeometry& tool);

}  // namespace kadr
