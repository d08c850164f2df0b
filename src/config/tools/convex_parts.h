#pragma once
// Decomposes a simple polygon into convex parts. For turning tools: used by config/tools/insert_keys, stock/tool/insert_shape.

#include <vector>

#include "config/tools/tool_geometry.h"

namespace kadr {

using InsertOutline = std::vector<InsertPoint>;

/// Returns the convex parts, counter-clockwise: one if the polygon is convex, else triangles. An outline of two points means the rectangle
/// with these opposite corners.
///   returns  an empty list if the polygon crosses itself or has no area
std::vector<InsertOutline> convex_parts(InsertOutline outline);

}  // namespace kadr
