#pragma once
// One sweep in one brick.

#include <cstdint>

#include "stock/brick/brick.h"
#include "stock/cut/local_sweep.h"
#include "stock/cut/swept_body.h"

namespace kadr {

/// Around what a sweep took away, from the brick's corner, mm.
struct RemovedBox {
  float least[3] = {1e30f, 1e30f, 1e30f};
  float most[3] = {-1e30f, -1e30f, -1e30f};
  bool any() const { return most[0] >= least[0]; }
};

/// What one cut took away.
struct CutOutcome {
  bool changed = false;
  double length = 0;              // of material on the upright lines, mm
  float depth = 0;                // greatest height of that above the tip, as it stands lowest over the line, mm
  float longest = 0;              // of the pieces taken off lines in any direction, mm
  RemovedBox* watched = nullptr;  // where it is asked for: pieces shorter than `least_piece` do not count
  float least_piece = 0;
};

/// Places of the lattice points along an axis from the brick's corner, mm, and the brick's own size.
struct BrickScale {
  explicit BrickScale(double cell);
  float cell, edge;
  alignas(32) float place[brick_edge];
};

/// Which of the processor's vectors are used. Each gives the same bits.
enum class LaneWidth : std::uint8_t { pair, wide };
/// The widest that this processor has.
LaneWidth widest_lanes();

/// Takes away what the body sweeps.
///   by  number of the sweep: the ends that it makes know it
void cut_brick(Brick& brick, const BrickScale& scale, const LocalSweep& sweep, const SweptBody& body, std::int32_t by, CutOutcome& outcome,
               LaneWidth width = widest_lanes());

}  // namespace kadr
