#pragma once
// PlannedTime: what the time of the planner of least time is made of.

#include "motion/look_ahead/limited_by.h"

namespace kadr {

/// Seconds. The sum of everything the planner handed out.
struct PlannedTime {
  struct Share {
    double all = 0;
    double speeding_up = 0, slowing_down = 0;  // of it
  };
  Share cutting, rapid;
  double dwell = 0;
  double tool_change = 0;  // and starts of the spindle

  void take(const TimedCells& cells, const MotionLimits& limits);
  double total() const { return cutting.all + rapid.all + dwell + tool_change; }
};

}  // namespace kadr
