#pragma once
// This file computes the minimum-time motion along a straight line from rest to rest. The motion has seven phases of constant jerk; some
// phases may have zero duration.

#include <vector>

#include "motion/least_time/motion_limits.h"
#include "motion/least_time/timed_cells.h"

namespace kadr {

/// Limits along a straight line in mm/s, mm/s² and mm/s³. Acceleration and jerk may be infinite.
struct LineLimits {
  double speed = 0, acceleration = 0, jerk = 0;
};

/// Returns the limits along a straight line that follow from the axis limits. `direction` is the unit vector of the line; `feed` is a
/// further speed limit in mm/s.
LineLimits limits_along(const MotionLimits& limits, const double* direction, double feed);

/// Appends to `to` the phases of the motion along the line. The closed form is the same as in NCT 7.0, with the build-up time T =
/// acceleration / jerk.
///   pre  length > 0, limits > 0
void rest_to_rest(double length, const LineLimits& limits, std::vector<TimeLaw>& to);

/// Returns the total duration of all phases, s.
double rest_to_rest_s(double length, const LineLimits& limits);

}  // namespace kadr
