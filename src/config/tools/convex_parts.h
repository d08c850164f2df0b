#pragma once
// Decomposes a simple polygon into convex parts, for turning tools. Used by config/tools/insert_keys, stock/tool/insert_shape.

#include <vector>

#include "config/tools/tool_geometry.h"

namespace kadr {

using InsertOutline = std::vector<InsertPoint>;

/// Returns the convex parts, whose points are in counter-clockwise order: the polygon itself if it is convex, else triangles. An outline of
/// two points means the rectangle with these opposite corners.
///   returns  an empty list if the polygon crosses itself or has no area
std::vector<InsertOutline> convex_parts(InsertOutline outline);

}  // namespace kadr
