#pragma once
// MotionLimits has the speed, acceleration and jerk limits of each axis.

#include <vector>

namespace kadr {

/// The limits of each axis in mm/s, mm/s² and mm/s³; a rotary axis has degrees instead of mm. All values are positive and finite.
struct MotionLimits {
  std::vector<double> speed, acceleration, jerk;
};

}  // namespace kadr
