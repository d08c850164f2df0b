#pragma once
// The least time along a path with limits of speed and acceleration only, exact but for the grid: what may still come to rest is found from
// the end backwards, then the motion goes forwards as fast as that allows. TOPP-RA: Pham, Pham 2018, IEEE T-RO 34(3).

#include "stretch.h"

namespace kadr::reference {

/// Constant path acceleration in each interval, the limits kept at both of its ends.
PathMotion without_jerk(const Grid& grid, const MotionLimits& limits);

}  // namespace kadr::reference
