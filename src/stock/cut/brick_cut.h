#pragma once
// Removes from one brick the material that an upright tool (its axis parallel to Z) sweeps.

#include <cstdint>

#include "stock/brick/brick.h"
#include "stock/cut/local_sweep.h"
#include "stock/cut/swept_body.h"

namespace kadr {

/// The box around the material that a sweep removed, in mm from the brick's corner.
struct RemovedBox {
  float least[3] = {1e30f, 1e30f, 1e30f};
  float most[3] = {-1e30f, -1e30f, -1e30f};
  bool any() const { return most[0] >= least[0]; }
};

/// What a sweep removed from a brick.
struct CutOutcome {
  bool changed = false;
  double length = 0;  // removed length, summed over the lattice lines along Z, mm
  // Greatest height in mm of removed material on a lattice line along Z, above the lowest position of the tool's tip over this line.
  float depth = 0;
  float longest = 0;  // longest interval removed from a lattice line of any direction, mm
  // Receives the box around the removed material unless nullptr; removed intervals shorter than `least_piece` mm are left out of the box.
  RemovedBox* watched = nullptr;
  float least_piece = 0;
};

/// The coordinates of the lattice points along an axis, mm from the brick's corner, and the size of the brick.
struct BrickScale {
  explicit BrickScale(double cell);
  float cell, edge;
  alignas(32) float place[brick_edge];
};

/// Vectors with which the processor computes: pair means two vectors of 16 bytes, wide means one of 32 bytes. Both give the same result,
/// bit for bit.
enum class LaneWidth : std::uint8_t { pair, wide };
/// Returns the greatest width that this processor supports.
LaneWidth widest_lanes();

/// Removes from the brick the material that the body sweeps.
///   by  number of the sweep, which is stored at the new ends of intervals
void cut_brick(Brick& brick, const BrickScale& scale, const LocalSweep& sweep, const SweptBody& body, std::int32_t by, CutOutcome& outcome,
               LaneWidth width = widest_lanes());

}  // namespace kadr
