// For cli/main; tests/run_interrupts.py.

#include "cli/stop.h"

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

#include "cli/terminal.h"
#include "out/result_file.h"

namespace kadr::cli {
namespace {

constexpr int first_of_signals = 128;                   // added to its number: the exit status, as shells have it
constexpr auto grace = std::chrono::milliseconds(150);  // in all 0.2 s are promised (design.md 10)

std::atomic<bool> asked = false;
std::atomic<int> signal_seen = 0;

/// Waits for the signals, which no other thread takes: here everything may be called, which a handler may not.
void watch(sigset_t signals) {
  int signal = 0;
  if (sigwait(&signals, &signal) != 0) return;
  signal_seen = signal;
  asked = true;
  std::this_thread::sleep_for(grace);
  ResultFile::discard_all();
  erase_bar();
  ::_exit(first_of_signals + signal);
}

}  // namespace

void catch_interrupts() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  if (pthread_sigmask(SIG_BLOCK, &signals, nullptr) != 0) return;
  std::thread(watch, signals).detach();
}

StopToken stop_token() { return StopToken(asked); }
bool interrupted() { return asked; }
int interrupted_status() { return first_of_signals + signal_seen; }

void survive_closed_pipes() {
  std::signal(SIGPIPE, SIG_IGN);
  // A standard stream that is closed must not become the first file that is opened.
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace kadr::cli
