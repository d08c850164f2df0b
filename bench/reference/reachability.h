#pragma once
// Computes the least time along a path with limits of speed and acceleration only, exact except for the grid. Backwards from the end it
// computes at each knot the greatest speed from which the motion can still stop; then forwards the motion that uses these speeds. Method:
// TOPP-RA (Pham, Pham 2018, IEEE T-RO 34(3)).

#include "stretch.h"

namespace kadr::reference {

/// Returns the motion with constant path acceleration in each interval; the limits are kept at both ends of each interval.
PathMotion without_jerk(const Grid& grid, const MotionLimits& limits);

}  // namespace kadr::reference
