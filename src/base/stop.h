#pragma once
// StopToken: whoever runs a program may want it to end before its end.

#include <atomic>

namespace kadr {

/// Asked by every loop that may take long; a value, handed down from whoever owns the flag. One read of memory, safe in any thread.
class StopToken {
 public:
  StopToken() = default;  // never asked to stop
  explicit StopToken(const std::atomic<bool>& flag) : flag_(&flag) {}

  bool asked() const { return flag_ != nullptr && flag_->load(std::memory_order_relaxed); }

 private:
  const std::atomic<bool>* flag_ = nullptr;
};

}  // namespace kadr
