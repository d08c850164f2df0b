#pragma once
// The feed of polar interpolation: near the rotation centre the path waits for the rotary axis. NCT 4.5:
//   at a point (u, w) with the tangent t:   F = min(F, most · r² · (π/180) / |u·t_w − w·t_u|)

#include "action/curve.h"

namespace kadr {

/// Limits of one motion on the polar surface.
struct PolarFeed {
  double feed = 0;         // commanded, mm/min along `along`
  double rotary_most = 0;  // degrees/min; 0: no limit
  FeedAlong along = FeedAlong::path;
};

/// Returns the actual feed at a part of the motion, mm/min.
double feed_at(const Curve& curve, const PolarFeed& limits, double part);

/// Returns the time per part at a part of the motion, min.
double minutes_per_part(const Curve& curve, const PolarFeed& limits, double part);

/// Returns the highest feed along the motion, mm/min.
double highest_feed(const Curve& curve, const PolarFeed& limits);

/// Returns the time of the motion, min.
double minutes(const Curve& curve, const PolarFeed& limits);

/// Returns the time of a rapid motion along the path, min: each axis at most at its rapid rate (mm/min, degrees/min).
double rapid_minutes(const Curve& curve, const AxisRoles& roles, const Axes& rapid);

/// Returns the time per part of a rapid motion at a part of it, min.
double rapid_minutes_per_part(const Curve& curve, const AxisRoles& roles, const Axes& rapid, double part);

}  // namespace kadr
