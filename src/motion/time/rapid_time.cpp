// This file computes the time of a rapid motion from rest to rest. Used by motion/look_ahead/look_ahead.

#include "motion/time/rapid_time.h"

#include <cmath>

namespace kadr {
namespace {

/// Returns the remaining time, s, of a ramp from the speed `top` to rest, counted from the instant at which the speed has fallen by the
/// fraction `part` (0 to 1).
double left_of_ramp(double top, double part, const Acceleration& acceleration) {
  constexpr int steps = 60;  // number of bisection steps; 60 steps reach the accuracy of double
  const Ramp down(top, 0, acceleration);
  double low = 0, high = down.seconds();
  for (int step = 0; step < steps; ++step) {
    const double middle = (low + high) / 2;
    (down.speed_at(middle) > top * (1 - part) ? low : high) = middle;
  }
  return down.seconds() - high;
}

}  // namespace

RapidTime rapid_together(const SpeedRules& rules, const PathShape& shape, double speed) {
  const Acceleration a = acceleration_of(rules, shape);
  return {travel_seconds(0, 0, shape.length, speed, a), top_speed(0, 0, shape.length, speed, a), 0};
}

RapidTime rapid_apart(const SpeedRules& rules, const Axes& travel, const Axes& rates) {
  RapidTime longest;
  for (std::size_t i = 0; i < max_axes; ++i) {
    const double distance = std::abs(travel[i]);
    if (distance == 0) continue;
    const Acceleration a{rules.acceleration[i], rules.build_up[i], rules.jerk_free};
    const double seconds = travel_seconds(0, 0, distance, rates[i], a);
    if (seconds <= longest.seconds) continue;
    const double top = top_speed(0, 0, distance, rates[i], a);
    longest = {seconds, top, left_of_ramp(top, rules.overlap_from, a)};
  }
  return longest;
}

}  // namespace kadr
