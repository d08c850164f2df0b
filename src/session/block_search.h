#pragma once
// BlockSearch: the result of the control's own block search, on controls that have one (nct 13.1). It lists the functions that the control
// executes at the end of the search, and the functions that the search omits. A restart (session/restart), in contrast, restores everything
// that was in force.

#include <string>
#include <vector>

#include "session/restart.h"

namespace kadr {

struct BlockSearch {
  /// An M code or a tool change, written as in a program: "M8"; "T5", or "T5 M6" if M6 changes the tool.
  struct Code {
    std::string text;
    Origin origin;  // location of the block that programmed the code last
    Action action;  // the action that the machine executes for the code
  };
  /// The modal codes, feed, speed, offsets, variables and tool position before the block at which the search ends. They are those after the
  /// execution of all blocks before that block (INFERRED, nct 13.1).
  Restart restart;
  /// The codes that the control executes at the end of the search, in the order of execution. First comes, from each group of M codes that
  /// the machine builder defines (N1341 to N1372), the code programmed last; these codes are sorted by the block of their last use. Then
  /// follows the tool change (N1338 #0 selects whether T or M6 causes the change).
  std::vector<Code> carried_out;
  /// The M codes that belong to no group, sorted by the block of their last use. The manual does not say whether the control executes them.
  std::vector<Code> of_no_group;
  /// Spindle and coolant states that were in force before the target and that `carried_out` does not restore, so they are missing after the
  /// search.
  std::vector<InForce> forgotten;
};

/// Runs the session from its present position to the first block that matches `target`. The variable #_BSEARCH is 1 during the search (nct
/// 23.1.11). The outlets receive no steps.
///   pre      the control has a block search: Control::search_rules() returns its rules
///   returns  nullopt if no block matches; Session::state() tells how the session ended
std::optional<BlockSearch> search_block(Session& session, Stepping& stepping, const StopPoint& target);

}  // namespace kadr
