#pragma once
// This file finds the limit that determines the speed of a planned cell. It is the limit of which the cell uses the largest fraction. The
// limits are those of motion/least_time/least_time.h.

#include "motion/least_time/planner.h"

namespace kadr {

enum class Limit : std::uint8_t {
  feed,          // the programmed feed, or the rapid rate with its override
  corner,        // the acceleration or jerk limit of an axis determines the speed in the rounding of a corner
  curve,         // the acceleration or jerk limit of an axis determines the speed in a curve, because of its curvature
  axis_speed,    // the speed limit of an axis determines the speed
  acceleration,  // the acceleration limit of an axis, while the path speed rises or falls
  jerk,          // the jerk limit of an axis, while the acceleration along the path changes
  pause,         // the axes are at rest: dwell, tool change
};
inline constexpr std::size_t limit_count = 7;

struct LimitedBy {
  Limit limit = Limit::feed;
  // Index of the axis that is at its limit. Not used for Limit::feed and Limit::pause, which concern the whole path.
  std::uint8_t axis = 0;
};

/// How much of their acceleration and jerk limits the axes use at one position of a cell.
struct LimitUsage {
  struct Share {
    double part = 0;        // the used fraction of the axis limit, for the axis nearest to its limit; 1: this axis is at its limit
    std::uint8_t axis = 0;  // index of the axis nearest to its limit
  };
  double speed = 0;  // path speed, mm/s
  Share of_acceleration, of_jerk;
};

/// Computes the used fractions of the limits at the position `part`, 0 to 1, in a cell; TimeLaw::at() defines `part`.
///   law  no fraction exceeds 1, except by the excess that the planner tolerates between its sample positions (docs/planner.md)
LimitUsage shares_at(const TimedCells& cells, std::size_t cell, double part, const MotionLimits& limits);

/// Returns the limit of which the cell uses the largest fraction, averaged over the start, the middle and the end of the cell. If the limit
/// is a rapid rate equal to an axis' speed limit, the result is Limit::axis_speed.
LimitedBy limited_by(const TimedCells& cells, std::size_t cell, const MotionLimits& limits);

}  // namespace kadr
