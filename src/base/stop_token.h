#pragma once
// StopToken: lets the owner of a run (a program, a simulation) end the run early, for example after Ctrl-C.

#include <atomic>

namespace kadr {

#ifdef __EMSCRIPTEN__
/// In a browser nobody else can set a stop flag while a run works: there is one thread. So each poll calls this function, which may look
/// whether the user wants a stop, and set the flag (web/engine.cpp). nullptr: none.
inline void (*look_for_stop)() = nullptr;
#endif

/// A StopToken reports whether a run has to end. Every loop that may take long polls a token. A token is a value, which the owner of the
/// stop flag passes to its callees; a poll is one relaxed read of memory, safe in any thread.
class StopToken {
 public:
  StopToken() = default;  // creates a token that never requests a stop
  explicit StopToken(const std::atomic<bool>& flag) : flag_(&flag) {}

  bool requested() const {
#ifdef __EMSCRIPTEN__
    if (flag_ != nullptr && look_for_stop != nullptr) look_for_stop();
#endif
    return flag_ != nullptr && flag_->load(std::memory_order_relaxed);
  }

 private:
  const std::atomic<bool>* flag_ = nullptr;
};

}  // namespace kadr
