#pragma once
// StopToken: lets the owner of a run (a program, a simulation) end the run early, for example after Ctrl-C.

#include <atomic>

namespace kadr {

/// A StopToken reports whether a run has to end. Every loop that may take long polls a token. A token is a value, which the owner of the
/// stop flag passes to its callees; a poll is one relaxed read of memory, safe in any thread.
class StopToken {
 public:
  StopToken() = default;  // creates a token that never requests a stop
  explicit StopToken(const std::atomic<bool>& flag) : flag_(&flag) {}

  bool requested() const { return flag_ != nullptr && flag_->load(std::memory_order_relaxed); }

 private:
  const std::atomic<bool>* flag_ = nullptr;
};

}  // namespace kadr
