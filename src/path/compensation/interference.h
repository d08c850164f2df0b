#pragma once
// Interference check: finds contour blocks whose compensated path runs opposite to the programmed direction. The check covers a window of
// blocks. If the check resolves the interference, the first block is joined with a later block. NCT 15.5.7.

#include <span>

#include "path/compensation/contour_offset.h"

namespace kadr {

/// A contour block with the vectors (programmed point to tool centre) at its ends.
struct CompensatedBlock {
  const ContourElement* element = nullptr;
  double radius = 0;
  double side = 0;
  bool plain = true;  // false for the block that starts compensation and the block that ends it
  Vec2 start_vector;
  // vectors at the end of the block; nullptr: the next block is unknown; empty: the offsets do not meet
  const JunctionVectors* end = nullptr;
};

/// The result of the check: block `next` of the window follows the first block directly, and the blocks between them are dropped.
struct ContourJoin {
  std::size_t next = 1;     // 1: no interference, nothing changes
  JunctionVectors vectors;  // vectors at the end of the first block, relative to its programmed end
  Vec2 start_vector;        // vector at the start of block `next`, relative to its programmed start
};

/// Returns true if the tool moves backwards in this block. The vectors at both ends must be known.
bool moves_backwards(const CompensatedBlock& block);

/// Checks the junction of the first two blocks against the junctions of the following blocks.
///   `further`       N1404: number of junctions to check beyond the next junction
///   `always_alarm`  parameter N1403 #1 AAL: an interference always raises the alarm
///   returns         nullopt for alarm 2049
///   law             the path of the first block itself is not checked: moves_backwards() does that
std::optional<ContourJoin> check_interference(std::span<const CompensatedBlock> window, std::size_t further, bool always_alarm);

}  // namespace kadr
