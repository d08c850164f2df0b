#pragma once
// MotionLimits: what each axis can do.

#include <vector>

namespace kadr {

/// Limits of each axis: mm/s, mm/s², mm/s³ (of rotary ones degrees); all above 0 and finite.
struct MotionLimits {
  std::vector<double> speed, acceleration, jerk;
};

}  // namespace kadr
