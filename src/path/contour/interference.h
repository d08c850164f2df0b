#pragma once
// Interference: a block of the contour whose compensated way goes against its programmed one. The check looks at a window of blocks
// and joins the first with a later one where that mends it. NCT 15.5.7.

#include <span>

#include "path/contour/contour_offset.h"

namespace kadr {

/// A block of the contour and what stands at its ends.
struct CompensatedBlock {
  const ContourElement* element = nullptr;
  double radius = 0;
  double side = 0;
  bool plain = true;  // neither the way in nor the way out
  Vec2 start_vector;
  const JunctionVectors* end = nullptr;  // nullptr: the next block is not known; none in it: the offsets do not meet
};

/// The first block of a window is followed by the block `next` of it, the blocks between are dropped.
struct ContourJoin {
  std::size_t next = 1;     // 1: all is well, nothing changes
  JunctionVectors vectors;  // at the end of the first block, from its programmed end
  Vec2 start_vector;        // of the block `next`, from its programmed start
};

/// Does the tool go back in this block? Both ends must be known.
bool goes_back(const CompensatedBlock& block);

/// Checks the junction of the first two blocks against those that follow.
///   `further`       N1404: how many more junctions than the next one
///   `always_alarm`  N1403 #1 AAL
///   returns         nothing: alarm 2049
///   law             the first block's own way is not looked at: goes_back() tells
std::optional<ContourJoin> check_interference(std::span<const CompensatedBlock> window, std::size_t further, bool always_alarm);

}  // namespace kadr
