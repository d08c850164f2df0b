#pragma once
// InsertBody: a convex body in the half plane of a turning tool. A part that spins loses the ring that it sweeps (stock/cut/ring_sweep.h).

#include <vector>

#include "config/tool_geometry.h"

namespace kadr {

enum class ToolPart : std::uint8_t;

/// A corner of the outline; a sharp one has radius 0.
struct InsertCorner {
  InsertPoint centre;
  double radius = 0;
};

/// The hull of its corners, counter-clockwise (x to the right, z up). The edge behind corner k has the outward normal `outward[k]`; between
/// two edges the outline turns by less than 180°. Lengths mm, from the programmed point.
struct InsertBody {
  ToolPart part;
  std::vector<InsertCorner> corners;
  std::vector<InsertPoint> outward;  // unit vectors
};

/// Cutting part, what is beyond its edges, holder.
///   pre  told_fault(geometry) is empty, and it turns
std::vector<InsertBody> insert_bodies(const ToolGeometry& geometry);

}  // namespace kadr
