#pragma once
// One ring in one brick of a part that spins.

#include <cstdint>

#include "base/vec.h"
#include "stock/cut/brick_cut.h"
#include "stock/cut/ring_sweep.h"

namespace kadr {

/// What one ring took away.
struct RingOutcome {
  bool changed = false;
  double length = 0;     // of material on the upright lines, mm
  float longest = 0;     // of the pieces taken off lines in any direction, mm
  bool watched = false;  // where is asked for: pieces thinner than `least_piece` along the radius (of level lines) or Z do not count
  double least_piece = 0;
  RingRange radii, heights;  // of what was taken away, where it is asked for

  bool any() const { return radii.from <= radii.to; }
};

/// Radii of a brick's own places.
struct BrickRing {
  double nearest, farthest;
};
/// `corner`: of the brick, from the axis.
BrickRing brick_ring(double corner_x, double corner_y, double edge);

/// Takes away what the insert sweeps. The answer does not depend on the processor.
///   corner  of the brick: x, y from the axis, z as in the sweep
///   by      number of the sweep: the ends that it makes know it
void cut_ring(Brick& brick, const BrickScale& scale, const Vec3& corner, const RingSweep& sweep, std::int32_t by, RingOutcome& outcome);

}  // namespace kadr
