#pragma once
// The end before the end: Ctrl-C, SIGTERM. Whoever works long is handed a token; whoever does not ask it in time is ended.

#include "base/stop.h"

namespace kadr::cli {

/// From here on Ctrl-C and SIGTERM ask for the end. To be called once, before any other thread begins.
/// A command that has not ended 0.15 s later is ended where it is: its unfinished files go away (ResultFile), the state file keeps
/// its last whole block.
void catch_interrupts();

/// Asked by every long loop.
StopToken stop_token();
bool interrupted();

/// Exit status of a command that was ended: 128 + the signal.
int interrupted_status();

/// A pipe whose reader has gone is an error of writing, not the silent end of the process.
void survive_closed_pipes();

}  // namespace kadr::cli
