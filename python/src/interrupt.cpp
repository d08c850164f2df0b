// Handles Ctrl-C while a program runs. Used by run.cpp and views.cpp; tested by tests/python_binding.py.

#include "interrupt.h"

#include <sys/syscall.h>
#include <unistd.h>

namespace kadr::python {
namespace {

std::atomic<std::atomic<bool>*> flag_now = nullptr;
static_assert(std::atomic<std::atomic<bool>*>::is_always_lock_free);  // a signal handler reads it, so the access must be lock-free
struct sigaction handled_before;

void on_interrupt(int signal, siginfo_t* info, void* context) {
  if (auto* const flag = flag_now.load()) flag->store(true);
  if ((handled_before.sa_flags & SA_SIGINFO) != 0) handled_before.sa_sigaction(signal, info, context);
  else handled_before.sa_handler(signal);
}

bool is_main_thread() { return ::syscall(SYS_gettid) == ::getpid(); }

}  // namespace

CatchInterrupt::CatchInterrupt(std::atomic<bool>& flag) {
  struct sigaction now = {};
  if (!is_main_thread() || ::sigaction(SIGINT, nullptr, &handled_before) != 0) return;
  const bool by_nobody =
      (handled_before.sa_flags & SA_SIGINFO) == 0 && (handled_before.sa_handler == SIG_DFL || handled_before.sa_handler == SIG_IGN);
  if (by_nobody) return;  // Python does not handle SIGINT: neither does Kadr
  flag_now = &flag;
  now.sa_sigaction = on_interrupt;
  now.sa_flags = SA_SIGINFO | SA_RESTART;
  sigemptyset(&now.sa_mask);
  installed_ = ::sigaction(SIGINT, &now, nullptr) == 0;
}

CatchInterrupt::~CatchInterrupt() {
  if (!installed_) return;
  ::sigaction(SIGINT, &handled_before, nullptr);
  flag_now = nullptr;
}

}  // namespace kadr::python
