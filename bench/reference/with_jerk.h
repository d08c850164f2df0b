#pragma once
// Computes the least time along a path with limits of speed, acceleration and jerk, as a dense nonlinear programme that Ipopt solves.
//
//   unknowns   path speed v and path acceleration a at each knot of the grid, the time t of each interval; path jerk j = (a₁ − a₀)/t
//   equations  v₀ t + (2 a₀ + a₁) t²/6 = h,   v₀ + (a₀ + a₁) t/2 = v₁      (h: length of the interval)
//   limits     at each knot |x′ a + x″ v²| ≤ A, at both ends of each interval |x′ j + 3 x″ v a + x‴ v³| ≤ J
//              (x: position of an axis, ′: derivative by path length, A and J: its acceleration and jerk limits)
//   minimise   Σ t
//
// The unknowns are functions of time, not of path length as ṡ² in motion/least_time/least_time: a stop is therefore no singularity. The
// problem is not convex: the best result of several start motions is used.

#include <optional>

#include "stretch.h"

namespace kadr::reference {

struct Found {
  PathMotion motion;
  int steps = 0;
};
/// Solves the problem from a start motion, which need not keep any limit.
///   returns  nullopt if no motion within the limits was found in `most_seconds`
std::optional<Found> with_jerk(const Grid& grid, const MotionLimits& limits, const PathMotion& start, double most_seconds);

}  // namespace kadr::reference
