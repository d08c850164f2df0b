#pragma once
// Prints the answers of the debugger about a start in mid-program.

#include "cli/job/drive.h"
#include "session/restart.h"

namespace kadr::cli {

/// Prints the blocks with which a program can start at the block before which the session is held. These blocks change the modes from the
/// state `begins` to the state in force there. Also prints what the operator must do by hand.
///   clearance  work coordinate of the tool axis at which the axes move to the restart position, mm
///   pre        the session is held before a block
void print_restart(Session& session, const Stepping& stepping, const Restart& begins, double clearance, Lang lang);

/// Executes the control's own block search to a line (nct 13.1). Prints which codes the search executes at its end and which it omits.
///   pre  the control has a block search
void print_search(Session& session, Stepping& stepping, const StopPoint& target, Lang lang);

}  // namespace kadr::cli
