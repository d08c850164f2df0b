#pragma once
// Finds the limit that determines the speed of a planned cell: of all limits that the cell must obey (motion/least_time/least_time.h),
// the one that it comes nearest to.

#include "motion/least_time/planner.h"

namespace kadr {

enum class Limit : std::uint8_t {
  feed,          // the programmed feed, or the rapid rate with its override
  corner,        // acceleration or jerk limit of an axis, in the rounding of a corner
  curve,         // acceleration or jerk limit of an axis in a curve, caused by the curvature
  axis_speed,    // speed limit of an axis
  acceleration,  // acceleration limit of an axis, while the path speed rises or falls
  jerk,          // jerk limit of an axis, while the acceleration along the path changes
  pause,         // the axes are at rest: dwell, tool change
};
inline constexpr std::size_t limit_count = 7;

struct LimitedBy {
  Limit limit = Limit::feed;
  std::uint8_t axis = 0;  // index of the axis that is at its limit; unused for Limit::feed and Limit::pause
};

/// How near the axes are to their limits at one position of a cell.
struct LimitUsage {
  struct Share {
    double part = 0;        // share of the limit used by the axis that is nearest to its limit; 1: the limit is reached
    std::uint8_t axis = 0;  // the axis nearest to its limit
  };
  double speed = 0;  // path speed, mm/s
  Share of_acceleration, of_jerk;
};

/// Computes the shares at the position `part`, 0 … 1, in a cell; TimeLaw::at() defines `part`.
///   law  no share exceeds 1, except by the excess that the planner tolerates between its sample positions (docs/planner.md)
LimitUsage shares_at(const TimedCells& cells, std::size_t cell, double part, const MotionLimits& limits);

/// Returns the limit with the greatest share, averaged over the start, the middle and the end of the cell. If the limit is a rapid rate
/// equal to an axis' speed limit, the result is Limit::axis_speed.
LimitedBy limited_by(const TimedCells& cells, std::size_t cell, const MotionLimits& limits);

}  // namespace kadr
