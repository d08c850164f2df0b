#pragma once
// The outline of a tool as it is drawn: what the cutter takes it for.

#include <vector>

#include "config/tool_geometry.h"

namespace kadr {

/// Cutting part, shank and holder from the tip up, round ends in short straight pieces; empty of a turning tool and of one without a shape.
///   law  no height is below the one before
std::vector<ProfilePoint> outline_of(const ToolGeometry& tool);

}  // namespace kadr
