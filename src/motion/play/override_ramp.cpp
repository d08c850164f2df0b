// OverrideRamp is a smooth change from one override to another, so that acceleration and jerk stay bounded. Used by motion/play/playback.

#include "motion/play/override_ramp.h"

namespace kadr {

OverrideRamp::OverrideRamp(OverrideFactor from, double to, double seconds) : seconds_(seconds), end_(to) {
  const double h = seconds, delta = to - from.share - h * (from.rate + h * from.bend / 2), slope = -from.rate - h * from.bend,
               bend = -from.bend;
  c_ = {from.share,
        from.rate,
        from.bend / 2,
        (10 * delta - h * (4 * slope - h * bend / 2)) / (h * h * h),
        (-15 * delta + h * (7 * slope - h * bend)) / (h * h * h * h),
        (6 * delta - h * (3 * slope - h * bend / 2)) / (h * h * h * h * h)};
}

OverrideFactor OverrideRamp::at(double t) const {
  if (t >= seconds_) return {end_, 0, 0};
  return {c_[0] + t * (c_[1] + t * (c_[2] + t * (c_[3] + t * (c_[4] + t * c_[5])))),
          c_[1] + t * (2 * c_[2] + t * (3 * c_[3] + t * (4 * c_[4] + t * 5 * c_[5]))),
          2 * c_[2] + t * (6 * c_[3] + t * (12 * c_[4] + t * 20 * c_[5]))};
}

double OverrideRamp::passed(double t) const {
  const double u = t < seconds_ ? t : seconds_;
  return u * (c_[0] + u * (c_[1] / 2 + u * (c_[2] / 3 + u * (c_[3] / 4 + u * (c_[4] / 5 + u * c_[5] / 6))))) + (t - u) * end_;
}

}  // namespace kadr
