#include "motion/pace.h"

#include <algorithm>
#include <cmath>

namespace kadr {

Pace::Pace(const AxisRoles& roles, const Curve& curve, const Motion& motion, double feed, const Axes& rapid)
    : roles_(roles),
      curve_(curve),
      limits_{feed, curve.surface() == PathSurface::polar ? motion.detail->rotary_most : 0, motion.along},
      rotary_(motion.second),
      rapid_(rapid) {}

double Pace::minutes_per_part(double part) const {
  return limits_.feed > 0 ? kadr::minutes_per_part(curve_, limits_, part) : rapid_minutes_per_part(curve_, roles_, rapid_, part);
}

double Pace::minutes(double from, double to) const {
  const double simpson = (minutes_per_part(from) + 4 * minutes_per_part((from + to) / 2) + minutes_per_part(to)) / 6 * (to - from);
  if (!(limits_.feed > 0 && limits_.rotary_most > 0)) return simpson;
  return std::max(simpson, std::fabs(curve_.at(to)[rotary_] - curve_.at(from)[rotary_]) / limits_.rotary_most);
}

}  // namespace kadr
