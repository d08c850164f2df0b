#pragma once
// What must be set before a program goes on in the middle, as blocks that its control reads.

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
  double feed = 0;                          // mm/min, of those at feed
  bool along_tool = false;                  // names the axis of the tool alone: a length may be taken with it
};

struct RestartBlocks {
  std::vector<std::string> blocks;
  std::vector<InForce> by_hand;  // what no block says: zeros, lengths, variables that only a program computes
};

/// The unit and variables first, the tool, then speed, codes in the order of their groups, offsets, spindle, coolant, the way, what the way
/// leaves otherwise.
///   wanted    what is to be set: Difference::wanted of each difference
///   in_force  Restart::in_force
///   alarms    word_has_no_room
Result<RestartBlocks> restart_blocks(const ControlDef& def, const std::vector<InForce>& wanted, const std::vector<InForce>& in_force,
                                     const std::vector<BlockWay>& way);

}  // namespace kadr
