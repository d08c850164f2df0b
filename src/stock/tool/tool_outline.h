#pragma once
// The outline of a tool for drawings; it has the shape that the cutting simulation uses.

#include <vector>

#include "config/tools/tool_geometry.h"

namespace kadr {

/// Returns the outline of cutting part, shank and holder as a polygon from the tip upwards; short straight lines replace arcs. Empty for
/// a turning tool and for a tool without a shape.
///   law  the heights of the points never decrease
std::vector<ProfilePoint> outline_of(const ToolGeometry& tool);

}  // namespace kadr
