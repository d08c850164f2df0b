#pragma once
// InsertBody: a convex outline of a turning tool (insert or holder) in the half plane through the axis of the part. On a spinning part, the
// outline removes the ring that it sweeps (stock/cut/ring_sweep.h).

#include <vector>

#include "config/tools/tool_geometry.h"

namespace kadr {

enum class ToolPart : std::uint8_t;

/// A corner of the outline, rounded with a radius; radius 0 is a sharp corner.
struct InsertCorner {
  InsertPoint centre;
  double radius = 0;
};

/// The outline is the convex hull of the corners, which are listed counter-clockwise (x to the right, z up). The straight edge after corner
/// k has the outward normal `outward[k]`. The directions of consecutive edges differ by less than 180°. Lengths are in mm, relative to the
/// programmed point.
struct InsertBody {
  ToolPart part;
  std::vector<InsertCorner> corners;
  std::vector<InsertPoint> outward;  // outward normals of the edges, unit vectors
};

/// Returns the outlines of the cutting part, of the insert beyond its cutting edges, and of the holder.
///   pre  tool_fault_message(geometry) is empty, and the tool is a turning tool
std::vector<InsertBody> insert_bodies(const ToolGeometry& geometry);

}  // namespace kadr
