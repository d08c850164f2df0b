#pragma once
// BlockSearch: the control's own block search, if it has one (nct 13.1): which functions the search executes before the program
// continues, and which functions it omits. A restart (session/restart), in contrast, restores everything that was in force.

#include <string>
#include <vector>

#include "session/restart.h"

namespace kadr {

struct BlockSearch {
  /// An M code or the tool change, as text: "M8"; "T5", or "T5 M6" if M6 changes the tool.
  struct Code {
    std::string text;
    Origin origin;  // the block that programmed the code last
    Action action;  // the action that the machine executes for the code
  };
  /// The modal codes, feed, speed, offsets, variables and tool position at the target, as if all blocks before the target had been executed
  /// (INFERRED, nct 13.1).
  Restart restart;
  /// The codes that are executed when the search ends, in this order: from each group of the machine builder (N1341 to N1372) the code
  /// programmed last, sorted by last use; then the tool change (N1338 #0: on T or on M6).
  std::vector<Code> carried_out;
  /// The M codes that belong to no group, sorted by last use; the manual does not say whether they are executed.
  std::vector<Code> of_no_group;
  /// Spindle and coolant states that the program has set before the target, and that `carried_out` does not restore.
  std::vector<InForce> forgotten;
};

/// Searches from the session's present position to the first block that matches the target; #_BSEARCH is 1 during the search (nct 23.1.11).
/// The outlets receive no steps.
///   pre      the control has a block search: Control::search_rules()
///   returns  nullopt if the block is not reached; the state of the session says why
std::optional<BlockSearch> search_block(Session& session, Stepping& stepping, const StopPoint& target);

}  // namespace kadr
