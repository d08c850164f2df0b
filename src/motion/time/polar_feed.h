#pragma once
// This file computes the feed of polar interpolation (NCT 4.5). Near the rotation centre the speed limit of the rotary axis reduces the
// feed F to
//   F = min(F, most · r² · (π/180) / |u·t_w − w·t_u|)
// at a point (u, w) that is r mm from the centre. Here t is the unit tangent, and `most` is the speed limit in degrees/min.

#include "action/curve.h"

namespace kadr {

/// Feed limits of one motion in polar interpolation.
struct PolarFeed {
  double feed = 0;  // commanded feed, mm/min; the member `along` says whether it refers to the programmed path or another length
  double max_rotary_speed = 0;  // speed limit of the rotary axis, degrees/min; 0: no limit
  FeedAlong along = FeedAlong::path;
};

/// Returns the actual feed, mm/min, at the position `part`, 0 to 1, in the motion.
double feed_at(const Curve& curve, const PolarFeed& limits, double part);

/// Returns dt/dpart in min: the derivative of the time with respect to `part` (0 to 1) at this position in the motion.
double minutes_per_part(const Curve& curve, const PolarFeed& limits, double part);

/// Returns the highest feed along the motion, mm/min.
double highest_feed(const Curve& curve, const PolarFeed& limits);

/// Returns the duration of the motion, min.
double minutes(const Curve& curve, const PolarFeed& limits);

/// Returns the duration, min, of a rapid motion along the path on which each axis moves at most at its rapid rate (mm/min, degrees/min).
double rapid_minutes(const Curve& curve, const AxisRoles& roles, const Axes& rapid);

/// Returns dt/dpart in min of a rapid motion: the derivative of the time with respect to `part`, at the position `part`, 0 to 1.
double rapid_minutes_per_part(const Curve& curve, const AxisRoles& roles, const Axes& rapid, double part);

}  // namespace kadr
