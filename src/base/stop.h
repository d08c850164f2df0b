#pragma once
// StopToken: lets the owner of a run end it early.

#include <atomic>

namespace kadr {

/// Every loop that may take long polls this. It is a value, passed down from the owner of the flag; a poll is one relaxed read of memory,
/// safe in any thread.
class StopToken {
 public:
  StopToken() = default;  // a token that never requests a stop
  explicit StopToken(const std::atomic<bool>& flag) : flag_(&flag) {}

  bool asked() const { return flag_ != nullptr && flag_->load(std::memory_order_relaxed); }

 private:
  const std::atomic<bool>* flag_ = nullptr;
};

}  // namespace kadr
