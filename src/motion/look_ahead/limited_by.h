#pragma once
// What keeps a cell of the planner from being faster: of all limits that it must obey the one that is nearest
// (motion/least_time/least_time.h).

#include "motion/least_time/planner.h"

namespace kadr {

enum class Limit : std::uint8_t {
  feed,          // programmed, or the rapid rate with its override
  corner,        // acceleration or jerk of an axis, in the rounding of a corner
  curve,         // … in a curve, by its curvature
  axis_speed,    // of an axis
  acceleration,  // of an axis, that speeds up or slows down
  jerk,          // … that begins or ends to
  pause,         // the axes stand: dwell, tool change
};
inline constexpr std::size_t limit_count = 7;

struct LimitedBy {
  Limit limit = Limit::feed;
  std::uint8_t axis = 0;  // not of feed and pause
};

/// How near the axes are to their limits at one place of a cell.
struct LimitShares {
  struct Share {
    double part = 0;        // of the limit, of the axis that is nearest to it; 1: it is reached
    std::uint8_t axis = 0;  // that one
  };
  double speed = 0;  // along the path, mm/s
  Share of_acceleration, of_jerk;
};

/// `part`: of the cell, TimeLaw::at().
///   law  no part is above 1, but for what the planner allows itself between the places where it looks (docs/planner.md)
LimitShares shares_at(const TimedCells& cells, std::size_t cell, double part, const MotionLimits& limits);

/// The nearest on the mean of the ends and the middle of the cell. A rapid rate that is that of an axis counts as the axis' speed.
LimitedBy limited_by(const TimedCells& cells, std::size_t cell, const MotionLimits& limits);

}  // namespace kadr
