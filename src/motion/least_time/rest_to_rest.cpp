// This file computes the minimum-time motion along a straight line from rest to rest. The motion has seven phases of constant jerk, some of
// which may have zero duration. Used by motion/least_time/planner.

#include "motion/least_time/rest_to_rest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kadr {
namespace {

/// A ramp from rest to a speed: `rising` seconds of positive jerk, `steady` seconds of constant acceleration, and again `rising` seconds of
/// negative jerk.
struct JerkRamp {
  double rising = 0, steady = 0, acceleration = 0, speed = 0;
  double seconds() const { return 2 * rising + steady; }
};

JerkRamp ramp_to(double speed, const LineLimits& limits) {
  // If the speed is so low that the acceleration limit is not reached, the peak acceleration is √(speed · jerk).
  const double reached = std::min(limits.acceleration, std::sqrt(speed * limits.jerk));
  const double rising = reached / limits.jerk;
  return {rising, std::max(0.0, speed / reached - rising), reached, speed};
}

/// Returns the greatest speed, mm/s, that a ramp over half of the length reaches.
double peak(double length, const LineLimits& limits) {
  const double a = limits.acceleration, rising = a / limits.jerk;
  if (length < 2 * a * rising * rising) return std::cbrt(length * length * limits.jerk / 4);
  return a / 2 * (std::sqrt(rising * rising + 4 * length / a) - rising);
}

double even_s(double length, const JerkRamp& ramp) { return std::max(0.0, length / ramp.speed - ramp.seconds()); }

}  // namespace

double rest_to_rest_s(double length, const LineLimits& limits) {
  const JerkRamp ramp = ramp_to(std::min(limits.speed, peak(length, limits)), limits);
  return 2 * ramp.seconds() + even_s(length, ramp);
}

LineLimits limits_along(const MotionLimits& limits, const double* direction, double feed) {
  constexpr double none = std::numeric_limits<double>::infinity();
  LineLimits line{feed, none, none};
  for (std::size_t a = 0; a < limits.speed.size(); ++a) {
    if (direction[a] == 0) continue;
    line.speed = std::min(line.speed, limits.speed[a] / std::fabs(direction[a]));
    line.acceleration = std::min(line.acceleration, limits.acceleration[a] / std::fabs(direction[a]));
    line.jerk = std::min(line.jerk, limits.jerk[a] / std::fabs(direction[a]));
  }
  return line;
}

void rest_to_rest(double length, const LineLimits& limits, std::vector<TimeLaw>& to) {
  const JerkRamp ramp = ramp_to(std::min(limits.speed, peak(length, limits)), limits);
  const double jerk = ramp.rising > 0 ? ramp.acceleration / ramp.rising : 0;
  const double even = even_s(length, ramp);
  double v = 0, a = 0;
  const auto phase = [&](double seconds, double j) {
    if (!(seconds > 0)) return;
    to.push_back(TimeLaw::of_jerk(seconds, v, a, j));
    v = to.back().speed(seconds);
    a += j * seconds;
  };
  if (ramp.rising == 0) a = ramp.acceleration;
  phase(ramp.rising, jerk);
  phase(ramp.steady, 0);
  phase(ramp.rising, -jerk);
  a = 0, v = ramp.speed;
  phase(even, 0);
  if (ramp.rising == 0) a = -ramp.acceleration;
  phase(ramp.rising, -jerk);
  phase(ramp.steady, 0);
  phase(ramp.rising, jerk);
}

}  // namespace kadr
