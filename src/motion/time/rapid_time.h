#pragma once
// This file computes the time of a rapid motion from rest to rest: NCT 4.1, 6.1, 7.0.1.

#include "motion/look_ahead/control_speed.h"

namespace kadr {

struct RapidTime {
  double seconds = 0;
  // The highest speed along the path, mm/s. If the axes move independently, this is the highest speed of the axis that takes the longest
  // time.
  double top = 0;
  double ahead = 0;  // time before the end of the motion at which the next motion may start, s (NCT 4.1.2)
};

/// Returns the time of a rapid motion along a straight line (NCT 4.1.1). `speed` is the path speed, mm/s, at which the slowest axis moves
/// at its rapid rate.
RapidTime rapid_together(const SpeedRules& rules, const PathShape& shape, double speed);

/// Returns the time of a rapid motion in which each axis moves at its own rapid rate with its own acceleration (NCT 4.1.2, INFERRED). The
/// next motion starts when the speed of the slowest axis has fallen by the percentage in the NCT parameter N0422. INFERRED: N0422 is a
/// percentage of the speed.
///   travel  signed travel of the axes, mm or degrees
///   rates  rapid rates of the axes, mm/s or degrees/s
RapidTime rapid_apart(const SpeedRules& rules, const Axes& travel, const Axes& rates);

}  // namespace kadr
