#pragma once
// Prints the debugger's answers about a start in mid-program.

#include "cli/job/drive.h"
#include "session/restart.h"

namespace kadr::cli {

/// Prints the blocks that restore the state in force at the block where the session is stopped, starting from the state in `begins`, and
/// what the operator must do by hand.
///   clearance  work coordinate of the tool axis at which the axes move to the restart position, mm
///   pre        the session is stopped before a block
void print_restart(Session& session, const Stepping& stepping, const Restart& begins, double clearance, Lang lang);

/// Runs the control's own block search to a line (nct 13.1). Prints what the search executes at its end and what it leaves out.
///   pre  the control has a block search
void print_search(Session& session, Stepping& stepping, const StopPoint& target, Lang lang);

}  // namespace kadr::cli
