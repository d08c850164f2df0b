#pragma once
// MotionLimits: speed, acceleration and jerk limits of each axis.

#include <vector>

namespace kadr {

/// Limits of each axis: mm/s, mm/s², mm/s³ (degrees for rotary axes); all positive and finite.
struct MotionLimits {
  std::vector<double> speed, acceleration, jerk;
};

}  // namespace kadr
