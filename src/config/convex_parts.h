#pragma once
// A simple polygon as convex parts. For turning tools: config/insert_keys, stock/tool/insert_shape.

#include <vector>

#include "config/tool_geometry.h"

namespace kadr {

using InsertOutline = std::vector<InsertPoint>;

/// Counter-clockwise; one part if the polygon is convex, else triangles. Two points are opposite corners of a rectangle.
///   returns  none: it crosses itself or has no area
std::vector<InsertOutline> convex_parts(InsertOutline outline);

}  // namespace kadr
