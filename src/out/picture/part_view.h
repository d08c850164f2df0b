#pragma once
// Draws a cut part as pixels, as it is seen from one direction in parallel projection.

#include <cstdint>
#include <functional>

#include "out/picture/canvas.h"
#include "stock/surface/surface.h"

namespace kadr {

/// The orientation of a view: three unit vectors that are perpendicular to each other.
struct ViewDirection {
  Vec3 right, up;
  Vec3 towards;  // from the part to the viewer
};

/// The section of a view: the point of the part in the middle of the image, the scale, and the size of the image.
struct ViewFrame {
  Vec3 centre;
  double scale = 1;  // pixels per mm
  int width = 0, height = 0;
};

/// A function that returns the colour, 0xRRGGBB, of the triangle with this index.
using TriangleColour = std::function<std::uint32_t(std::size_t triangle)>;

/// Draws the surface. Near triangles hide far triangles. A triangle is brighter the more it faces the viewer. Pixels outside the surface
/// are transparent.
Pixels part_view(const Surface& surface, const ViewDirection& direction, const ViewFrame& frame, const TriangleColour& colour_of);

}  // namespace kadr
