#pragma once
// RunningSpindles: which spindles turn at a step of the run. It is used by session/cutting/turned_cutting.

#include <cstdint>

#include "action/action.h"

namespace kadr {

class RunningSpindles {
 public:
  explicit RunningSpindles(SpindleDir first) : turning_(is_turning(first) ? 1 : 0) {}

  void take(const Spindle& spindle) {
    const std::uint32_t bit = bit_of(spindle.number);
    turning_ = is_turning(spindle.dir) ? turning_ | bit : turning_ & ~bit;
    if (spindle.rpm > 0) speedless_ &= ~bit;
  }
  void take(const Speed& speed) {
    const std::uint32_t bit = bit_of(speed.number);
    speedless_ = speed.value > 0 ? speedless_ & ~bit : speedless_ | bit;
  }
  /// True if at least one spindle turns. Any of them may turn the part.
  bool any() const { return (turning_ & ~speedless_) != 0; }

 private:
  static bool is_turning(SpindleDir dir) { return dir == SpindleDir::cw || dir == SpindleDir::ccw; }
  static std::uint32_t bit_of(int spindle) { return spindle >= 1 && spindle <= 32 ? std::uint32_t{1} << (spindle - 1) : 0; }

  std::uint32_t turning_;        // bit mask of the spindles that M3 or M4 has started
  std::uint32_t speedless_ = 0;  // bit mask of the spindles whose programmed speed is 0
};

}  // namespace kadr
