#pragma once
// Writes blocks that bring a control into a given state (modes, tool, offsets, variables) before a program continues in mid-program.

#include <string>
#include <vector>

#include "action/in_force.h"
#include "base/result.h"
#include "config/control/control_def.h"

namespace kadr {

/// A straight motion to a position in work coordinates.
struct BlockMove {
  bool rapid = true;
  std::vector<std::pair<char, double>> to;  // axis letter and end position, mm or degrees
  double feed = 0;                          // feed, mm/min; has no meaning for a rapid
  bool along_tool = false;                  // true: only the tool axis moves, so the block may also apply a tool length
};

struct RestartBlocks {
  std::vector<std::string> blocks;
  std::vector<InForce> by_hand;  // state that no block can set: work offsets, tool lengths, and variables that only the program computes
};

/// Writes the blocks in this order: unit, variables, tool, speed, codes in the order of their groups, offsets, spindle, coolant, the
/// motions to the position. At the end come the modes that those motions have changed.
///   required  the state to be set: the Difference::required of each difference
///   in_force  Restart::in_force
///   alarms    word_has_no_room
Result<RestartBlocks> restart_blocks(const ControlDef& def, const std::vector<InForce>& required, const std::vector<InForce>& in_force,
                                     const std::vector<BlockMove>& path);

}  // namespace kadr
