#pragma once
// ProgressClock: limits the progress reports of a long task to ten per second.

#include <chrono>

namespace kadr {

class ProgressClock {
 public:
  /// Returns true if the last report was made at least a tenth of a second ago. The result true counts as a report, so the next tenth of a
  /// second starts now.
  bool is_due() {
    const Clock::time_point now = Clock::now();
    if (now - reported_ < interval) return false;
    reported_ = now;
    return true;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr Clock::duration interval = std::chrono::milliseconds(100);
  Clock::time_point reported_{};
};

}  // namespace kadr
