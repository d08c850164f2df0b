// For cli/main; tests/run_interrupts.py.

#include "cli/stop.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

#include "cli/terminal.h"
#include "out/trace/result_file.h"

namespace kadr::cli {
namespace {

constexpr int first_of_signals = 128;                   // added to its number: the exit status, as shells have it
constexpr auto grace = std::chrono::milliseconds(150);  // in all 0.2 s are promised (design.md 10)

std::atomic<bool> asked = false;

/// SIGINT and SIGTERM, which every thread holds back: one that was sent stays pending to the end.
sigset_t held_back() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

/// The signal that was sent; 0: none.
int pending() {
  sigset_t signals;
  if (sigpending(&signals) != 0) return 0;
  if (sigismember(&signals, SIGINT) == 1) return SIGINT;
  return sigismember(&signals, SIGTERM) == 1 ? SIGTERM : 0;
}

/// Waits for the signals: here everything may be called, which a handler may not. They are not taken, so that whoever asks
/// knows of them at once, even before this thread came round: in `make | kadr run -` a Ctrl-C ends the input as well.
void watch(int signals) {
  pollfd sent = {signals, POLLIN, 0};
  while (::poll(&sent, 1, -1) < 0)
    if (errno != EINTR) return;
  const int signal = pending();
  asked = true;
  std::this_thread::sleep_for(grace);
  ResultFile::discard_all();
  erase_bar();
  ::_exit(first_of_signals + signal);
}

}  // namespace

void catch_interrupts() {
  const sigset_t signals = held_back();
  const int wakes = ::signalfd(-1, &signals, SFD_CLOEXEC);
  if (wakes < 0 || pthread_sigmask(SIG_BLOCK, &signals, nullptr) != 0) return;
  std::thread(watch, wakes).detach();
}

StopToken stop_token() { return StopToken(asked); }
bool interrupted() { return pending() != 0; }
int interrupted_status() { return first_of_signals + pending(); }

void survive_closed_pipes() {
  std::signal(SIGPIPE, SIG_IGN);
  // A standard stream that is closed must not become the first file that is opened.
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace kadr::cli
