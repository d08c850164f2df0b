#pragma once
// Interference: blocks of the contour whose compensated path goes against the programmed one. The check covers a window of blocks and
// joins the first block with a later one if that resolves the interference. NCT 15.5.7.

#include <span>

#include "path/contour/contour_offset.h"

namespace kadr {

/// A block of the contour with the vectors at its ends.
struct CompensatedBlock {
  const ContourElement* element = nullptr;
  double radius = 0;
  double side = 0;
  bool plain = true;  // false for the entry and the exit of compensation
  Vec2 start_vector;
  const JunctionVectors* end = nullptr;  // nullptr: the next block is unknown; empty: the offsets do not meet
};

/// A join: the first block of a window is followed by its block number `next`, the blocks between are dropped.
struct ContourJoin {
  std::size_t next = 1;     // 1: no interference, nothing changes
  JunctionVectors vectors;  // at the end of the first block, from its programmed end
  Vec2 start_vector;        // of the block `next`, from its programmed start
};

/// Returns true if the tool goes backwards in this block. Both ends must be known.
bool goes_back(const CompensatedBlock& block);

/// Checks the junction of the first two blocks against the following ones.
///   `further`       N1404: number of junctions to check beyond the next one
///   `always_alarm`  N1403 #1 AAL
///   returns         nullopt for alarm 2049
///   law             the path of the first block itself is not checked: goes_back() does that
std::optional<ContourJoin> check_interference(std::span<const CompensatedBlock> window, std::size_t further, bool always_alarm);

}  // namespace kadr
