#pragma once
// The interference check finds contour blocks whose compensated path is opposite to the programmed direction (NCT 15.5.7). The check covers
// a window of blocks. If the check can resolve the interference, it joins the first block with a later block.

#include <span>

#include "path/compensation/contour_offset.h"

namespace kadr {

/// A contour block with the vectors at its two ends. A vector leads from the programmed point to the tool's centre.
struct CompensatedBlock {
  const ContourElement* element = nullptr;
  double radius = 0;
  double side = 0;
  bool plain = true;  // False for the block that starts compensation and for the block that ends compensation.
  Vec2 start_vector;
  // The vectors at the end of the block. nullptr: the next block is unknown. No vectors: the offsets do not meet.
  const JunctionVectors* end = nullptr;
};

/// The result of the check. Block `next` of the window follows the first block directly; the blocks between the two are dropped.
struct ContourJoin {
  std::size_t next = 1;  // number of the block in the window that follows the first block; 1: there is no interference, so nothing changes
  JunctionVectors vectors;  // the compensation vectors at the end of the first block, relative to the programmed end of this block
  Vec2 start_vector;        // the compensation vector at the start of block `next`, relative to the programmed start of this block
};

/// Returns true if the tool moves backwards in this block. The vectors at both ends of the block must be known.
bool moves_backwards(const CompensatedBlock& block);

/// Checks the junction of the first two blocks against the junctions of the following blocks.
///   `further`       parameter N1404: the number of junctions to check beyond the next junction
///   `always_alarm`  parameter N1403 #1 AAL: an interference always raises the alarm
///   returns         nullopt for alarm 2049
///   law             the path of the first block itself is not checked here, but by moves_backwards()
std::optional<ContourJoin> check_interference(std::span<const CompensatedBlock> window, std::size_t further, bool always_alarm);

}  // namespace kadr
