// Pace computes how the time of a motion is distributed along its path where the axes do not move in proportion to the feed. These motions
// are polar interpolation (NCT 4.5), cylindrical interpolation (NCT 4.6), and feed per revolution of a spindle whose speed depends on the
// tool's position (NCT 11.5). Used by motion/least_time/axis_motion; tested by tests/motion/pace_test.cpp.

#include "motion/time/pace.h"

#include <algorithm>
#include <cmath>

namespace kadr {

Pace::Pace(const AxisRoles& roles, const Curve& curve, const Motion& motion, double feed, const Axes& rapid, const SpindleTurning& spindle)
    : roles_(roles),
      curve_(curve),
      limits_{feed, curve.surface() == PathSurface::polar ? motion.detail->max_rotary_speed : 0, motion.along},
      rotary_(motion.second),
      rapid_(rapid),
      spindle_(spindle),
      by_spindle_(feed > 0 && motion.unit == FeedUnit::mm_per_rev && spindle.surface.on && curve.surface() == PathSurface::plane) {}

int Pace::pieces() const {
  constexpr double change = 0.02;  // greatest relative change of speed within one part of the motion
  constexpr double least = 1e-3;   // lower bound of the distance from the rotation centre, mm
  constexpr double most = 1000;
  const SurfaceSpeed& surface = spindle_.surface;
  if (!by_spindle_ || surface.axis >= max_axes) return 1;
  const double from = curve_.at(0)[surface.axis], to = curve_.at(1)[surface.axis];
  const double nearest = from * to > 0 ? std::min(std::fabs(from), std::fabs(to)) : 0;
  return static_cast<int>(
      std::ceil(std::min(most, std::fabs(to - from) / (change * std::max({nearest, surface.radius(surface.most), least})))));
}

double Pace::minutes_per_part(double part) const {
  if (by_spindle_) return curve_.rate(limits_.along, part) / spindle_.at(curve_.at(part));
  return limits_.feed > 0 ? kadr::minutes_per_part(curve_, limits_, part) : rapid_minutes_per_part(curve_, roles_, rapid_, part);
}

double Pace::minutes(double from, double to) const {
  const double simpson = (minutes_per_part(from) + 4 * minutes_per_part((from + to) / 2) + minutes_per_part(to)) / 6 * (to - from);
  if (!(limits_.feed > 0 && limits_.max_rotary_speed > 0)) return simpson;
  return std::max(simpson, std::fabs(curve_.at(to)[rotary_] - curve_.at(from)[rotary_]) / limits_.max_rotary_speed);
}

}  // namespace kadr
