#pragma once
// Cuts one ring in one brick of a spinning part.

#include <cstdint>

#include "base/vec.h"
#include "stock/cut/brick_cut.h"
#include "stock/cut/ring_sweep.h"

namespace kadr {

/// What one ring removed.
struct RingOutcome {
  bool changed = false;
  double length = 0;     // of removed material on the upright lines, mm
  float longest = 0;     // longest piece removed from a line in any direction, mm
  bool watched = false;  // records the range: pieces thinner than `least_piece` along the radius (of level lines) or Z do not count
  double least_piece = 0;
  RingRange radii, heights;  // of the removed material, if watched

  bool any() const { return radii.from <= radii.to; }
};

/// The least and greatest radius in a brick.
struct BrickRing {
  double nearest, farthest;
};
/// `corner` of the brick, relative to the axis.
BrickRing brick_ring(double corner_x, double corner_y, double edge);

/// Removes what the insert sweeps. The result does not depend on the processor.
///   corner  of the brick: x, y from the axis, z as in the sweep
///   by      number of the sweep, stored at the ends that it makes
void cut_ring(Brick& brick, const BrickScale& scale, const Vec3& corner, const RingSweep& sweep, std::int32_t by, RingOutcome& outcome);

}  // namespace kadr
