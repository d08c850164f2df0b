#pragma once
// Finds what keeps a planned cell from being faster: the nearest of all limits that it must obey (motion/least_time/least_time.h).

#include "motion/least_time/planner.h"

namespace kadr {

enum class Limit : std::uint8_t {
  feed,          // programmed, or the rapid rate with its override
  corner,        // acceleration or jerk of an axis, in the rounding of a corner
  curve,         // the same in a curve, because of its curvature
  axis_speed,    // of an axis
  acceleration,  // of an axis, while speeding up or slowing down
  jerk,          // of an axis, while acceleration builds up or fades
  pause,         // the axes are at rest: dwell, tool change
};
inline constexpr std::size_t limit_count = 7;

struct LimitedBy {
  Limit limit = Limit::feed;
  std::uint8_t axis = 0;  // unused for feed and pause
};

/// How near the axes are to their limits at one position of a cell.
struct LimitShares {
  struct Share {
    double part = 0;        // share of the limit that the nearest axis uses; 1: the limit is reached
    std::uint8_t axis = 0;  // that axis
  };
  double speed = 0;  // along the path, mm/s
  Share of_acceleration, of_jerk;
};

/// Computes the shares at `part` of a cell, see TimeLaw::at().
///   law  no part exceeds 1, except by what the planner tolerates between its sample positions (docs/planner.md)
LimitShares shares_at(const TimedCells& cells, std::size_t cell, double part, const MotionLimits& limits);

/// Returns the limit that is nearest in the mean of the ends and the middle of the cell. A rapid rate that equals that of an axis counts
/// as the axis' speed.
LimitedBy limited_by(const TimedCells& cells, std::size_t cell, const MotionLimits& limits);

}  // namespace kadr
