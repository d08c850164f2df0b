#pragma once
// BlockSearch: the control's own block search, where it has one (nct 13.1): what it brings before the program goes on, and what it forgets.
// Beside a restart (session/restart), which brings all that was in force.

#include <string>
#include <vector>

#include "session/restart.h"

namespace kadr {

struct BlockSearch {
  /// M code, or the tool change: "M8"; "T5", or "T5 M6" where M6 does it.
  struct Code {
    std::string text;
    Origin origin;  // where it was programmed last
    Action action;  // of the machine
  };
  /// Modal codes, feed, speed, offsets, variables, and where the tool must be: as if everything before had run (INFERRED, 13.1).
  Restart restart;
  /// Carried out when the search ends, in this order: of each group of the machine builder (N1341 to N1372) the last one programmed, in the
  /// order of their last use; then the tool change (N1338 #0: on T or on M6).
  std::vector<Code> carried_out;
  /// M codes of no group: the manual does not say what becomes of them; in the order of their last use.
  std::vector<Code> of_no_group;
  /// Of the spindle and the coolant: in force in the program there, and not brought by `carried_out`.
  std::vector<InForce> forgotten;
};

/// Searches from where the session stands to the first block for which the target holds; #_BSEARCH is 1 meanwhile (23.1.11). Nothing is
/// handed to the outlets.
///   pre      the control has a block search: Control::search_rules()
///   returns  nothing: the block is not reached; the session tells what came instead
std::optional<BlockSearch> search_block(Session& session, Stepping& stepping, const StopPoint& target);

}  // namespace kadr
