#pragma once
// Draws a cut part as pixels, seen from one side, without perspective.

#include <cstdint>
#include <functional>

#include "out/picture/canvas.h"
#include "stock/surface/surface.h"

namespace kadr {

/// Unit vectors at right angles to each other.
struct ViewDirection {
  Vec3 right, up;
  Vec3 towards;  // from the part to the eye
};

/// The part's point in the middle of the picture, and the picture's size.
struct ViewFrame {
  Vec3 centre;
  double scale = 1;  // pixels per mm
  int width = 0, height = 0;
};

/// Returns the colour of a triangle, 0xRRGGBB.
using TriangleColour = std::function<std::uint32_t(std::size_t triangle)>;

/// Draws the surface. Near triangles hide far ones; each is lit by how it faces the eye. What is not covered is transparent.
Pixels part_view(const Surface& surface, const ViewDirection& direction, const ViewFrame& frame, const TriangleColour& colour_of);

}  // namespace kadr
