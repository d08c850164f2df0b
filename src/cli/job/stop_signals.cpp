// Ends a command early on a signal. This file is used by cli/main and tested by tests/run_interrupts.py.

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

// offset of the exit status: as in shells, the status is this number plus the number of the signal
constexpr int first_of_signals = 128;
// time in which a command can end by itself after a signal; the limit ensures that every command ends within 0.2 s
// (a command that moves a machine asks for more)
std::atomic<std::chrono::milliseconds> grace = std::chrono::milliseconds(150);

std::atomic<bool> stop_requested = false;

constexpr std::array ending = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

/// Returns the signals that end the command, except those that were ignored at the start (nohup, a command with & in a script). All threads
/// block the returned signals, so a signal that has arrived remains pending.
sigset_t held_back() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : ending) {
    struct sigaction now {};
    if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) sigaddset(&signals, signal);  // NOLINT: a union
  }
  return signals;
}

volatile std::sig_atomic_t handled = 0;  // number of the signal that arrived, if no thread waits for signals

/// Returns the number of the pending signal; 0 if no signal is pending.
int pending() {
  if (handled != 0) return handled;
  sigset_t signals;
  if (sigpending(&signals) != 0) return 0;
  const auto* const sent = std::find_if(ending.begin(), ending.end(), [&](int signal) { return sigismember(&signals, signal) == 1; });
  return sent == ending.end() ? 0 : *sent;
}

/// Waits for the signals in a separate thread. In contrast to a signal handler, the thread may call every function. The signals remain
/// pending, so a caller that polls for them sees them at once, even before this thread runs. That matters in `make | kadr run -`, where
/// Ctrl-C also ends the input.
void watch(int signals) {
  pollfd sent = {signals, POLLIN, 0};
  while (::poll(&sent, 1, -1) < 0)
    if (errno != EINTR) return;
  const int signal = pending();
  stop_requested = true;
  std::this_thread::sleep_for(grace.load());
  ResultFile::discard_all();
  erase_bar();
  ::_exit(first_of_signals + signal);
}

/// Handles the signals without a thread, as far as a signal handler can. A signal of the timer marks the end of the time in which a command
/// can end by itself.
void handle_instead(const sigset_t& signals) {
  std::signal(SIGALRM, [](int) {
    ResultFile::discard_all();
    ::_exit(first_of_signals + handled);
  });
  struct sigaction how {};
  how.sa_handler = [](int signal) {  // NOLINT: a union
    handled = signal;
    stop_requested = true;
    const std::chrono::milliseconds time = grace;
    const itimerval after = {{0, 0}, {time.count() / 1000, time.count() % 1000 * 1000}};
    (void)::setitimer(ITIMER_REAL, &after, nullptr);
  };
  how.sa_flags = static_cast<int>(SA_RESETHAND);  // a second signal ends the process at once, as the handler is then removed
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

void allow_after_signal(std::chrono::milliseconds time) { grace = time; }

StopToken stop_token() { return StopToken(stop_requested); }
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
  // If a standard stream is closed, the first opened file would become that stream. Therefore /dev/null takes the number of a closed
  // stream. It is opened in the wrong direction, so that reading from the stream or writing to it remains an error.
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace kadr::cli
