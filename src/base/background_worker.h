#pragma once
// BackgroundWorker: executes one task at a time in a thread of its own, in parallel with the caller. The function wait_for() implements how
// the two threads wait for each other.

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>

#include "base/thread.h"

namespace kadr {

/// Waits until `done` returns true. Polls first, because the awaited thread is usually nearly ready, then sleeps until `changes` is
/// notified. Waking up takes some 20 µs, longer in a virtual machine; 500 polls take about as long. On a busy machine, more polls would use
/// up the time slice of the awaited thread.
template <class Value, class Done>
void wait_for(const std::atomic<Value>& changes, const Done& done, int max_polls = 500) {
  for (int look = 0;; ++look) {
    const Value seen = changes.load(std::memory_order_acquire);
    if (done()) return;
    if (look >= max_polls) changes.wait(seen, std::memory_order_acquire);
#if defined(__x86_64__) || defined(__i386__)
    else __builtin_ia32_pause();
#endif
  }
}

class BackgroundWorker {
 public:
  BackgroundWorker() = default;
  /// Waits until the task that was begun is done.
  ~BackgroundWorker();
  BackgroundWorker(const BackgroundWorker&) = delete;
  BackgroundWorker& operator=(const BackgroundWorker&) = delete;

  /// Starts a task. Until wait() returns, only the task may access the data that it needs. With a single processor, or if no thread can be
  /// created, begin() executes the task itself before it returns.
  ///   pre  wait() was called after the previous begin()
  void begin(std::function<void()> work);
  /// Waits until the task is done.
  void wait();
  bool is_begun() const { return begun_; }

 private:
  void work();
  void execute();
  bool claim(std::uint32_t number);
  void finish();
  bool is_done() const { return done_.load(std::memory_order_acquire) == given_.load(std::memory_order_relaxed); }

  std::function<void()> work_;
  std::exception_ptr failure_;
  // true: a task has begun and its result is still awaited: begin() was called, and wait() has not been called after it
  bool begun_ = false;
  // True if there is a single processor, or if no thread could be created; begin() then executes the task itself.
  bool alone_ = false;
  Thread thread_;  // the worker thread, started by the first begin()
  // Numbers of tasks, counted from 1: of the last task begun, of the last task claimed by a thread, of the last task done.
  std::atomic<std::uint32_t> given_ = 0, claimed_ = 0, done_ = 0;
  std::atomic<bool> over_ = false;
};

}  // namespace kadr
