#pragma once
// The time of a rapid motion from rest to rest. NCT 4.1, 6.1, 7.0.1.

#include "motion/look_ahead/control_speed.h"

namespace kadr {

struct RapidTime {
  double seconds = 0;
  double top = 0;    // the highest speed, mm/s along the path (if the axes move independently: of the one that takes longest)
  double ahead = 0;  // s before its end at which the next motion may start (4.1.2)
};

/// Returns the time along a straight line (4.1.1). `speed`: mm/s, at which the slowest axis has its rapid rate.
RapidTime rapid_together(const SpeedRules& rules, const PathShape& shape, double speed);

/// Returns the time if each axis moves at its own rapid rate with its own acceleration (4.1.2, INFERRED). The next motion starts when the
/// speed of the slowest axis has fallen by N0422 (INFERRED: per cent of the speed).
///   ways   signed travel of the axes, mm or degrees
///   rates  their rapid rates, per s
RapidTime rapid_apart(const SpeedRules& rules, const Axes& ways, const Axes& rates);

}  // namespace kadr
