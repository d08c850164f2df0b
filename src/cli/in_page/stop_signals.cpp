// The command under Node, which only tests use: there a signal ends the process at once, and nothing waits for it.

#include "cli/job/stop_signals.h"

namespace kadr::cli {

void catch_interrupts() {}
void allow_after_signal(std::chrono::milliseconds) {}
StopToken stop_token() { return {}; }
bool interrupted() { return false; }
int interrupted_status() { return 0; }
void survive_refused_writing() {}

}  // namespace kadr::cli
