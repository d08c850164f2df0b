// Thread: creates and joins threads. Used by base/background_worker, cli/job/stop_signals, panel, server, session/run_ahead, stock; tested
// by tests/base/thread_test.cpp and tests/every_command.py.

#include "base/thread.h"

#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

namespace kadr {
namespace {

/// Starts a thread. If the system cannot create a thread, the returned object is not joinable.
std::thread begun(std::function<void()> work) {
  try {
    return std::thread(std::move(work));
  } catch (const std::system_error&) {
  } catch (const std::bad_alloc&) {
  }
  return {};
}

}  // namespace

int threads_at_once() {
#ifdef __linux__
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0) return CPU_COUNT(&set);
#endif
#ifdef __EMSCRIPTEN__
  return 1;  // the browser tells its processors, but gives a page without special headers no threads
#else
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
#endif
}

bool Thread::begin(std::function<void()> work) {
  auto thrown = std::make_unique<std::exception_ptr>();
  thread_ = begun([to = thrown.get(), work = std::move(work)] {
    try {
      work();
    } catch (...) {
      *to = std::current_exception();
    }
  });
  thrown_ = std::move(thrown);
  return is_begun();
}

void Thread::begin_or_throw(std::function<void()> work) {
  if (!begin(std::move(work))) throw NoThread();
}

bool begin_alone(std::function<void()> work) {
  std::thread thread = begun([work = std::move(work)] {
    try {
      work();
    } catch (...) {  // NOLINT: nobody waits for this thread, so nobody can receive its exception
    }
  });
  if (!thread.joinable()) return false;
  thread.detach();
  return true;
}

void run_parallel(int count, const std::function<void(int)>& work) {
  std::vector<Thread> others(static_cast<std::size_t>(count > 1 ? count - 1 : 0));
  std::exception_ptr thrown;
  const auto here = [&](int i) {
    try {
      work(i);
    } catch (...) {
      thrown = std::current_exception();
    }
  };
  int begun = 1;
  while (begun < count && others[static_cast<std::size_t>(begun - 1)].begin([&work, i = begun] { work(i); })) ++begun;
  here(0);
  for (int i = begun; i < count && !thrown; ++i) here(i);
  for (Thread& other : others) {
    other.wait();
    if (!thrown) thrown = other.thrown();
  }
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace kadr
