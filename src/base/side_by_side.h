#pragma once
// SideBySide: one piece of work at a time in a thread of its own, beside whoever gave it. And what threads wait with.

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>

#include "base/thread.h"

namespace kadr {

/// Waits until `done`: looks for a while, as mostly the other side is nearly ready, then sleeps until `changes` does. To be woken takes
/// some 20 µs, in a virtual machine longer; 500 looks take about as long. More would use up the time slice of the very thread that is
/// waited for where the machine is busy.
template <class Value, class Done>
void wait_for(const std::atomic<Value>& changes, const Done& done, int most_looks = 500) {
  for (int look = 0;; ++look) {
    const Value seen = changes.load(std::memory_order_acquire);
    if (done()) return;
    if (look >= most_looks) changes.wait(seen, std::memory_order_acquire);
#if defined(__x86_64__) || defined(__i386__)
    else __builtin_ia32_pause();
#endif
  }
}

/// That this process may use.
bool has_several_processors();

class SideBySide {
 public:
  SideBySide() = default;
  /// Waits for what is begun.
  ~SideBySide();
  SideBySide(const SideBySide&) = delete;
  SideBySide& operator=(const SideBySide&) = delete;

  /// Begins it; what it needs stays alone with it until wait(). Where there is one processor, or no thread is to be had, it is done at
  /// once.
  ///   pre  wait() was called since the last one
  void begin(std::function<void()> work);
  /// Until it is done.
  ///   throws  what it threw
  void wait();
  bool is_begun() const { return begun_; }

 private:
  void work();
  void carry_out();
  bool claim(std::uint32_t number);
  void finish();
  bool is_done() const { return done_.load(std::memory_order_acquire) == given_.load(std::memory_order_relaxed); }

  std::function<void()> work_;
  std::exception_ptr failure_;
  bool begun_ = false;                                             // and not waited for
  bool alone_ = false;                                             // no thread is to be had
  Thread thread_;                                                  // begun with the first work
  std::atomic<std::uint32_t> given_ = 0, claimed_ = 0, done_ = 0;  // by number, from 1
  std::atomic<bool> over_ = false;
};

}  // namespace kadr
