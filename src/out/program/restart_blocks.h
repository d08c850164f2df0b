#pragma once
// Writes, as blocks of the control, what must be set before a program can continue from its middle.

#include <string>
#include <vector>

#include "action/in_force.h"
#include "base/result.h"
#include "config/control_def.h"

namespace kadr {

/// A straight motion to work coordinates.
struct BlockWay {
  bool rapid = true;
  std::vector<std::pair<char, double>> to;  // axis letter, mm or degrees
  double feed = 0;                          // mm/min; only if not rapid
  bool along_tool = false;                  // names only the tool axis, so that a tool length may be applied in the same block
};

struct RestartBlocks {
  std::vector<std::string> blocks;
  std::vector<InForce> by_hand;  // what no block can set: work offsets, tool lengths, variables that only a program computes
};

/// Writes the blocks in this order: the unit, variables, the tool, speed, codes in the order of their groups, offsets, spindle, coolant,
/// the path, and then what the path has changed.
///   wanted    what is to be set: the Difference::wanted of each difference
///   in_force  Restart::in_force
///   alarms    word_has_no_room
Result<RestartBlocks> restart_blocks(const ControlDef& def, const std::vector<InForce>& wanted, const std::vector<InForce>& in_force,
                                     const std::vector<BlockWay>& way);

}  // namespace kadr
