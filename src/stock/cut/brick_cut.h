#pragma once
// Cuts one sweep of an upright tool in one brick.

#include <cstdint>

#include "stock/brick/brick.h"
#include "stock/cut/local_sweep.h"
#include "stock/cut/swept_body.h"

namespace kadr {

/// The box around what a sweep removed, from the brick's corner, mm.
struct RemovedBox {
  float least[3] = {1e30f, 1e30f, 1e30f};
  float most[3] = {-1e30f, -1e30f, -1e30f};
  bool any() const { return most[0] >= least[0]; }
};

/// What one cut removed.
struct CutOutcome {
  bool changed = false;
  double length = 0;              // of removed material on the upright lines, mm
  float depth = 0;                // greatest height of that above the tip, where the tip is lowest over the line, mm
  float longest = 0;              // longest piece removed from a line in any direction, mm
  RemovedBox* watched = nullptr;  // the removed box, if requested: pieces shorter than `least_piece` do not count
  float least_piece = 0;
};

/// Positions of the lattice points along an axis from the brick's corner, mm, and the size of the brick.
struct BrickScale {
  explicit BrickScale(double cell);
  float cell, edge;
  alignas(32) float place[brick_edge];
};

/// Width of the processor's vectors to use. Both give the same bits.
enum class LaneWidth : std::uint8_t { pair, wide };
/// Returns the widest that this processor supports.
LaneWidth widest_lanes();

/// Removes what the body sweeps.
///   by  number of the sweep, stored at the ends that it makes
void cut_brick(Brick& brick, const BrickScale& scale, const LocalSweep& sweep, const SweptBody& body, std::int32_t by, CutOutcome& outcome,
               LaneWidth width = widest_lanes());

}  // namespace kadr
