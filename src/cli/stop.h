#pragma once
// The end before the end: Ctrl-C, SIGTERM, a terminal that closes (SIGHUP), Ctrl-\ (SIGQUIT). Whoever works long is handed a token; whoever
// does not ask it in time is ended.

#include <spawn.h>

#include "base/stop.h"

namespace kadr::cli {

/// From here on these signals ask for the end, but one that is ignored from the beginning (nohup). To be called once, before any other
/// thread begins. A command that has not ended 0.15 s later is ended where it is: its unfinished files go away (ResultFile), the state file
/// keeps its last whole block.
void catch_interrupts();

/// Asked by every long loop.
StopToken stop_token();
bool interrupted();

/// Exit status of a command that was ended: 128 + the signal.
int interrupted_status();

/// A pipe whose reader has gone and a file beyond the limit of its size (ulimit -f) are errors of writing, not the end of the process.
void survive_refused_writing();

/// What another program that is begun gets: signals as this one found them.
struct SignalsOfChild {
  SignalsOfChild();
  ~SignalsOfChild() { posix_spawnattr_destroy(&attributes); }
  SignalsOfChild(const SignalsOfChild&) = delete;
  SignalsOfChild& operator=(const SignalsOfChild&) = delete;
  posix_spawnattr_t attributes;
};

}  // namespace kadr::cli
