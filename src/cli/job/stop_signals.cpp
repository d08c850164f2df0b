// Ends a command early on a signal. Used by cli/main; tested by tests/run_interrupts.py.

#include "cli/job/stop_signals.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/signalfd.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

#include "base/thread.h"
#include "cli/job/terminal.h"
#include "out/trace/result_file.h"

namespace kadr::cli {
namespace {

constexpr int first_of_signals = 128;                   // the exit status is this plus the signal's number, as in shells
constexpr auto grace = std::chrono::milliseconds(150);  // time that a command has to end by itself, so that it ends within 0.2 s in all

std::atomic<bool> asked = false;

constexpr std::array ending = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

/// Returns the signals that end the command, without those that were ignored from the beginning (nohup, a command with & in a script).
/// Every thread blocks the returned signals, so that a signal stays pending after it has arrived.
sigset_t held_back() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : ending) {
    struct sigaction now {};
    if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) sigaddset(&signals, signal);  // NOLINT: a union
  }
  return signals;
}

volatile std::sig_atomic_t handled = 0;  // the signal that arrived, if no thread waits for signals

/// Returns the signal that was sent; 0: none.
int pending() {
  if (handled != 0) return handled;
  sigset_t signals;
  if (sigpending(&signals) != 0) return 0;
  const auto* const sent = std::find_if(ending.begin(), ending.end(), [&](int signal) { return sigismember(&signals, signal) == 1; });
  return sent == ending.end() ? 0 : *sent;
}

/// Runs in a thread of its own and waits for the signals. Unlike a signal handler, it may call every function. The signals stay pending, so
/// that a caller that polls sees them at once, even before this thread runs: in `make | kadr run -` Ctrl-C ends the input as well.
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

/// Handles the signals without a thread, as far as a signal handler can; a timer signal marks the end of the grace period.
void handle_instead(const sigset_t& signals) {
  std::signal(SIGALRM, [](int) {
    ResultFile::discard_all();
    ::_exit(first_of_signals + handled);
  });
  struct sigaction how {};
  how.sa_handler = [](int signal) {  // NOLINT: a union
    handled = signal;
    asked = true;
    const itimerval after = {{0, 0}, {0, std::chrono::microseconds(grace).count()}};
    (void)::setitimer(ITIMER_REAL, &after, nullptr);
  };
  how.sa_flags = static_cast<int>(SA_RESETHAND);  // a second signal ends the process at once
  for (const int signal : ending)
    if (sigismember(&signals, signal) == 1) (void)::sigaction(signal, &how, nullptr);
}

}  // namespace

void catch_interrupts() {
  const sigset_t signals = held_back();
  const int wakes = ::signalfd(-1, &signals, SFD_CLOEXEC);
  if (wakes >= 0 && pthread_sigmask(SIG_BLOCK, &signals, nullptr) == 0) {
    if (begin_alone([wakes] { watch(wakes); })) return;
    (void)pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  }
  if (wakes >= 0) ::close(wakes);
  handle_instead(signals);
}

StopToken stop_token() { return StopToken(asked); }
bool interrupted() { return pending() != 0; }
int interrupted_status() { return first_of_signals + pending(); }

SignalsOfChild::SignalsOfChild() : attributes() {
  posix_spawnattr_init(&attributes);
  sigset_t none, usual;
  sigemptyset(&none);
  sigemptyset(&usual);
  for (const int signal : {SIGPIPE, SIGXFSZ}) sigaddset(&usual, signal);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
}

void survive_refused_writing() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // A closed standard stream must not become the first file that is opened.
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace kadr::cli
