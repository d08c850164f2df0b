#pragma once
// PartView: a cut part as pixels, seen from one side, without perspective.

#include <cstdint>
#include <functional>

#include "out/picture/canvas.h"
#include "stock/surface/surface.h"

namespace kadr {

/// Unit vectors, at right angles to each other.
struct ViewDirection {
  Vec3 right, up;
  Vec3 towards;  // from the part to the eye
};

/// Of the middle of the part, and how it is drawn.
struct ViewFrame {
  Vec3 centre;
  double scale = 1;  // pixels a mm
  int width = 0, height = 0;
};

/// 0xRRGGBB of a triangle.
using TriangleColour = std::function<std::uint32_t(std::size_t triangle)>;

/// Triangles hide what is behind them; each is lit by how it faces the eye. What is not covered is transparent.
Pixels part_view(const Surface& surface, const ViewDirection& direction, const ViewFrame& frame, const TriangleColour& colour_of);

}  // namespace kadr
