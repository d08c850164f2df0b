#pragma once
// PlannedTime: the components of the time of a least-time plan.

#include "motion/look_ahead/limited_by.h"

namespace kadr {

/// Sums over everything that the planner has emitted, s.
struct PlannedTime {
  struct Share {
    double all = 0;
    double speeding_up = 0, slowing_down = 0;  // included in `all`
  };
  Share cutting, rapid;
  double dwell = 0;
  double tool_change = 0;  // including starts of the spindle

  void take(const TimedCells& cells, const MotionLimits& limits);
  double total() const { return cutting.all + rapid.all + dwell + tool_change; }
};

}  // namespace kadr
