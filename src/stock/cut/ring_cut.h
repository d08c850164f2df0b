#pragma once
// Removes the ring that a turning tool sweeps from one brick of a spinning part.

#include <cstdint>

#include "base/vec.h"
#include "stock/cut/brick_cut.h"
#include "stock/cut/ring_sweep.h"

namespace kadr {

/// What a ring removed from a brick.
struct RingOutcome {
  bool changed = false;
  double length = 0;  // removed length, summed over the lattice lines along Z, mm
  float longest = 0;  // longest interval removed from a lattice line of any direction, mm
  // True if `radii` and `heights` are to be recorded. They exclude removed intervals thinner than `least_piece` mm; the thickness is
  // measured along the radius for lines along X and Y, and along Z for lines along Z.
  bool watched = false;
  double least_piece = 0;
  RingRange radii, heights;  // ranges of radius and height of the removed material, mm; set only if `watched` is true

  bool any() const { return radii.from <= radii.to; }
};

/// The least and the greatest distance of a brick's points from the axis of the part, mm.
struct BrickRing {
  double nearest, farthest;
};
/// Returns the BrickRing of a brick. `corner_x`, `corner_y`: position of the brick's corner relative to the axis of the part, mm.
BrickRing brick_ring(double corner_x, double corner_y, double edge);

/// Removes from the brick the material that the insert sweeps. The result does not depend on the processor.
///   corner  of the brick: x, y from the axis of the part, z in the coordinates of the sweep
///   by      number of the sweep, which is stored at the new ends of intervals
void cut_ring(Brick& brick, const BrickScale& scale, const Vec3& corner, const RingSweep& sweep, std::int32_t by, RingOutcome& outcome);

}  // namespace kadr
