#pragma once
// Computes the least time along a path with limits of speed, acceleration and jerk, as a dense nonlinear programme that Ipopt solves.
//
//   unknowns   path speed v and acceleration a at each knot of the grid, the time t of each interval; its path jerk is (a₁ − a₀)/t
//   equations  v₀ t + (2 a₀ + a₁) t²/6 = h,   v₀ + (a₀ + a₁) t/2 = v₁
//   limits     at each knot |x′ a + x″ v²| ≤ A, at both ends of each interval |x′ j + 3 x″ v a + x‴ v³| ≤ J
//   Σ t        to be the least
//
// It is formulated in time, not in ṡ² as in motion/least_time/least_time: a stop is nothing special. It is not convex: the best of several
// starts counts.

#include <optional>

#include "stretch.h"

namespace kadr::reference {

struct Found {
  PathMotion motion;
  int steps = 0;
};
/// Starts from a motion that need not keep any limit.
///   returns  nullopt if no motion within the limits was found in `most_seconds`
std::optional<Found> with_jerk(const Grid& grid, const MotionLimits& limits, const PathMotion& start, double most_seconds);

}  // namespace kadr::reference
