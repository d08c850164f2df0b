#pragma once
// InsertBody: a convex body in the half plane of a turning tool. It removes the ring that it sweeps from a spinning part
// (stock/cut/ring_sweep.h).

#include <vector>

#include "config/tool_geometry.h"

namespace kadr {

enum class ToolPart : std::uint8_t;

/// A corner of the outline; radius 0 is a sharp corner.
struct InsertCorner {
  InsertPoint centre;
  double radius = 0;
};

/// The convex hull of its corners, counter-clockwise (x to the right, z up). The edge after corner k has the outward normal
/// `outward[k]`; the outline turns by less than 180° between two edges. Lengths in mm, from the programmed point.
struct InsertBody {
  ToolPart part;
  std::vector<InsertCorner> corners;
  std::vector<InsertPoint> outward;  // unit vectors
};

/// Returns the cutting part, the part beyond its edges, and the holder.
///   pre  told_fault(geometry) is empty, and it is a turning tool
std::vector<InsertBody> insert_bodies(const ToolGeometry& geometry);

}  // namespace kadr
