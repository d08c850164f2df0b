#pragma once
// PlannedTime divides the time of a least-time plan into cutting, rapid motion, dwell and tool change.

#include "motion/look_ahead/limited_by.h"

namespace kadr {

/// Time sums in s over all cells that the planner has emitted.
struct PlannedTime {
  struct Share {
    double all = 0;
    double speeding_up = 0, slowing_down = 0;  // times in s with rising and with falling path speed; both are included in `all`
  };
  Share cutting, rapid;
  double dwell = 0;
  double tool_change = 0;  // tool change times and spindle start times, s

  void take(const TimedCells& cells, const MotionLimits& limits);
  double total() const { return cutting.all + rapid.all + dwell + tool_change; }
};

}  // namespace kadr
