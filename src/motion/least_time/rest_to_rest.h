#pragma once
// The least time of a straight line from rest to rest: seven phases of constant jerk, some of which may have no duration.

#include <vector>

#include "motion/least_time/motion_limits.h"
#include "motion/least_time/timed_cells.h"

namespace kadr {

/// Limits along a straight line: mm/s, mm/s², mm/s³; acceleration and jerk may be infinite.
struct LineLimits {
  double speed = 0, acceleration = 0, jerk = 0;
};

/// Returns the limits of the axes along a straight line, `way` its unit vector, with `feed`, mm/s, as a further limit of the speed.
LineLimits limits_along(const MotionLimits& limits, const double* way, double feed);

/// Appends the phases of the line. NCT 7.0 has the same closed form with T = acceleration / jerk.
///   pre  length > 0, limits > 0
void rest_to_rest(double length, const LineLimits& limits, std::vector<TimeLaw>& to);

/// Returns the duration of all phases, s.
double rest_to_rest_s(double length, const LineLimits& limits);

}  // namespace kadr
