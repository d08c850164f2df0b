#pragma once
// The feed of polar interpolation: near the rotation centre the speed limit of the rotary axis reduces the feed F. NCT 4.5:
//   at a point (u, w), r mm from the centre, with the unit tangent t, `most` degrees/min:   F = min(F, most · r² · (π/180) / |u·t_w −
//   w·t_u|)

#include "action/curve.h"

namespace kadr {

/// Feed limits of one motion in polar interpolation.
struct PolarFeed {
  double feed = 0;              // commanded feed, mm/min, along the length that `along` selects
  double max_rotary_speed = 0;  // speed limit of the rotary axis, degrees/min; 0: no limit
  FeedAlong along = FeedAlong::path;
};

/// Returns the actual feed at the position `part`, 0 … 1, in the motion, mm/min.
double feed_at(const Curve& curve, const PolarFeed& limits, double part);

/// Returns dt/dpart, the time derivative with respect to `part` (0 … 1) at this position in the motion, min.
double minutes_per_part(const Curve& curve, const PolarFeed& limits, double part);

/// Returns the highest feed along the motion, mm/min.
double highest_feed(const Curve& curve, const PolarFeed& limits);

/// Returns the time of the motion, min.
double minutes(const Curve& curve, const PolarFeed& limits);

/// Returns the time of a rapid motion along the path, min: each axis at most at its rapid rate (mm/min, degrees/min).
double rapid_minutes(const Curve& curve, const AxisRoles& roles, const Axes& rapid);

/// Returns dt/dpart of a rapid motion at the position `part`, 0 … 1, min.
double rapid_minutes_per_part(const Curve& curve, const AxisRoles& roles, const Axes& rapid, double part);

}  // namespace kadr
