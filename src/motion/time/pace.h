#pragma once
// Pace computes how the time of a motion is distributed along its path where the axes do not move in proportion to the feed. There are
// three cases. In polar interpolation the feed applies in the programmed plane, and the rotary axis has a speed limit (NCT 4.5). In
// cylindrical interpolation the feed applies on the unrolled surface (NCT 4.6). The third case is feed per revolution of a spindle whose
// speed depends on the tool's position (NCT 11.5).

#include "action/axis_roles.h"
#include "motion/time/polar_feed.h"
#include "motion/time/spindle_turning.h"

namespace kadr {

/// The distribution of time along one curve. The curve must outlive the Pace, because the Pace keeps a reference to the curve.
class Pace {
 public:
  /// Prepares the distribution of the time along `curve`, the curve of `motion`.
  ///   feed   feed in mm/min along the length to which the motion's feed refers; 0: rapid motion
  ///   rapid  rapid rate of each axis, mm/min or degrees/min
  Pace(const AxisRoles& roles, const Curve& curve, const Motion& motion, double feed, const Axes& rapid, const SpindleTurning& spindle);

  /// True if the axes move in proportion to the feed along the whole path.
  bool is_even() const { return curve_.surface() == PathSurface::plane && !by_spindle_ && limits_.along != FeedAlong::turn; }
  /// Returns the number of equal parts into which the motion must be divided, so that the feed changes little within each part.
  int pieces() const;

  /// Returns the time, min, between two positions, 0 to 1, in the motion. The result of Simpson's rule is accurate enough to distribute the
  /// time of the whole motion.
  ///   law  the rotary axis of polar interpolation does not exceed its speed limit
  double minutes(double from, double to) const;

 private:
  double minutes_per_part(double part) const;

  const AxisRoles& roles_;
  const Curve& curve_;
  PolarFeed limits_;
  std::size_t rotary_;
  Axes rapid_;
  const SpindleTurning& spindle_;
  bool by_spindle_;
};

}  // namespace kadr
