#pragma once
// Ends a command early: Ctrl-C, SIGTERM, a terminal that closes (SIGHUP), Ctrl-\ (SIGQUIT). Long work gets a token to check; a command that
// does not check it in time is ended.

#include <spawn.h>

#include "base/stop.h"

namespace kadr::cli {

/// From here on these signals request the end, except one that was ignored from the beginning (nohup). Call it once, before any other
/// thread starts. A command that has not ended 0.15 s later is ended where it is: its unfinished files are deleted (ResultFile), and the
/// state file keeps its last complete block.
void catch_interrupts();

/// Checked in every long loop.
StopToken stop_token();
bool interrupted();

/// Exit status of a command that was ended by a signal: 128 + the signal.
int interrupted_status();

/// Makes a pipe whose reader has gone, and a file beyond its size limit (ulimit -f), errors of writing instead of the end of the process.
void survive_refused_writing();

/// Signal settings for a child process: as this process found them.
struct SignalsOfChild {
  SignalsOfChild();
  ~SignalsOfChild() { posix_spawnattr_destroy(&attributes); }
  SignalsOfChild(const SignalsOfChild&) = delete;
  SignalsOfChild& operator=(const SignalsOfChild&) = delete;
  posix_spawnattr_t attributes;
};

}  // namespace kadr::cli
