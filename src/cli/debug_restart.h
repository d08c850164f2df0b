#pragma once
// What the debugger tells of going on in mid program.

#include "cli/drive.h"
#include "session/restart.h"

namespace kadr::cli {

/// The blocks that bring what is in force where the session is held, beginning with what `begins` has; what they leave to the hand.
///   clearance  work coordinate of the axis of the tool over which the way goes, mm
///   pre        it is held
void tell_restart(Session& session, const Stepping& stepping, const Restart& begins, double clearance, Lang lang);

/// The control's own block search to a line (nct 13.1): what it carries out at its end, what it forgets.
///   pre  the control has one
void tell_search(Session& session, Stepping& stepping, const StopPoint& target, Lang lang);

}  // namespace kadr::cli
