#pragma once
// Ends a command early after Ctrl-C, SIGTERM, SIGHUP (closed terminal) or Ctrl-\\ (SIGQUIT). Long work polls a stop token. A command that
// does not end in time is ended by force.

#include <spawn.h>

#include <chrono>

#include "base/stop_token.h"

namespace kadr::cli {

/// From now on these signals request a stop, except those that were ignored when the command started (nohup). Call this function once,
/// before any other thread starts. A command that has not ended 0.15 s after the signal is ended by force. Then its unfinished files are
/// deleted (ResultFile), and the state file contains the last complete block.
void catch_interrupts();

/// Lets the command continue for this time after a signal, instead of 0.15 s: a command that moves a machine must bring it to rest first.
void allow_after_signal(std::chrono::milliseconds time);

/// Returns the token that every long loop polls.
StopToken stop_token();
bool interrupted();

/// Returns the exit status of a command that a signal has ended: 128 + the number of the signal.
int interrupted_status();

/// Makes writing to a closed pipe, or beyond the file size limit (ulimit -f), a write error. By default the system would end the process.
void survive_refused_writing();

/// Signal settings for a child process, which are those that this process had at its start.
struct SignalsOfChild {
  SignalsOfChild();
  ~SignalsOfChild() { posix_spawnattr_destroy(&attributes); }
  SignalsOfChild(const SignalsOfChild&) = delete;
  SignalsOfChild& operator=(const SignalsOfChild&) = delete;
  posix_spawnattr_t attributes;
};

}  // namespace kadr::cli
