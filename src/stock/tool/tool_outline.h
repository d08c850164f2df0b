#pragma once
// The outline of a tool for drawings. It has the same shape as the tool in the cutting simulation.

#include <vector>

#include "config/tools/tool_geometry.h"

namespace kadr {

/// Returns the outline of the cutting part, the shank and the holder as a polygon from the tip upwards. Short straight lines replace arcs.
/// The result is empty for a turning tool and for a tool without a shape.
///   law  the heights of the points never decrease
std::vector<ProfilePoint> outline_of(const ToolGeometry& tool);

}  // namespace kadr
