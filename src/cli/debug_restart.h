#pragma once
// Prints what the debugger reports about continuing in mid-program.

#include "cli/drive.h"
#include "session/restart.h"

namespace kadr::cli {

/// Prints the blocks that establish what is in force where the session is held, starting from the state in `begins`, and what must be done
/// by hand.
///   clearance  work coordinate of the tool axis at which the path crosses, mm
///   pre        the session is held
void tell_restart(Session& session, const Stepping& stepping, const Restart& begins, double clearance, Lang lang);

/// Runs the control's own block search to a line (nct 13.1) and prints what it executes at its end and what it leaves out.
///   pre  the control has a block search
void tell_search(Session& session, Stepping& stepping, const StopPoint& target, Lang lang);

}  // namespace kadr::cli
