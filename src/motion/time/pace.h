#pragma once
// Pace: how the time of a motion is shared by its pieces where the axes do not go as the feed counts: in polar interpolation, whose
// feed is that in the programmed plane and whose rotary axis has a limit (NCT 4.5), in cylindrical, on the unrolled surface (4.6), and at a
// feed per revolution of a spindle that turns by where the tool is (11.5).

#include "action/axis_roles.h"
#include "motion/time/polar_feed.h"
#include "motion/time/spindle_turning.h"

namespace kadr {

/// A view of a curve: it must outlive this.
class Pace {
 public:
  ///   feed   mm/min along what the motion's feed counts along; 0: rapid
  ///   rapid  of each axis, mm/min or degrees/min
  Pace(const AxisRoles& roles, const Curve& curve, const Motion& motion, double feed, const Axes& rapid, const SpindleTurning& spindle);

  /// All along the path the axes go as the feed counts.
  bool is_even() const { return curve_.surface() == PathSurface::plane && !by_spindle_ && limits_.along != FeedAlong::turn; }
  /// Equal pieces in each of which the feed changes little.
  int pieces() const;

  /// Time between two parts, near enough to share out what the whole motion takes (Simpson's rule).
  ///   law  the rotary axis of polar interpolation keeps its limit
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
