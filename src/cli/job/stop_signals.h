#pragma once
// Ends a command early: Ctrl-C, SIGTERM, a closed terminal (SIGHUP), Ctrl-\\ (SIGQUIT). Long work checks a stop token; a command that
// does not check it in time is ended.

#include <spawn.h>

#include "base/stop_token.h"

namespace kadr::cli {

/// From here on these signals request a stop, except signals that were ignored when the command started (nohup). Call it once, before any
/// other thread starts. A command that has not ended 0.15 s after the signal is ended at once: its unfinished files are deleted
/// (ResultFile), and the state file keeps its last complete block.
void catch_interrupts();

/// Returns the token that every long loop checks.
StopToken stop_token();
bool interrupted();

/// Exit status of a command that was ended by a signal: 128 + the signal.
int interrupted_status();

/// Writing to a closed pipe, or beyond the file size limit (ulimit -f), becomes a write error instead of ending the process.
void survive_refused_writing();

/// Signal settings for a child process: the settings that this process had at its start.
struct SignalsOfChild {
  SignalsOfChild();
  ~SignalsOfChild() { posix_spawnattr_destroy(&attributes); }
  SignalsOfChild(const SignalsOfChild&) = delete;
  SignalsOfChild& operator=(const SignalsOfChild&) = delete;
  posix_spawnattr_t attributes;
};

}  // namespace kadr::cli
