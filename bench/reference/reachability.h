#pragma once
// Computes the least time along a path with limits of speed and acceleration only, exact except for the grid: backwards from the end, the
// speeds from which the motion can still stop; then forwards, as fast as they allow. TOPP-RA: Pham, Pham 2018, IEEE T-RO 34(3).

#include "stretch.h"

namespace kadr::reference {

/// Uses constant path acceleration in each interval, with the limits kept at both of its ends.
PathMotion without_jerk(const Grid& grid, const MotionLimits& limits);

}  // namespace kadr::reference
