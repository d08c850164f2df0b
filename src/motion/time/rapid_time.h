#pragma once
// The time of a rapid motion, from rest to rest. NCT 4.1, 6.1, 7.0.1.

#include "motion/look_ahead/control_speed.h"

namespace kadr {

struct RapidTime {
  double seconds = 0;
  double top = 0;    // the highest speed, mm/s along the path (of axes apart: of the one that takes longest)
  double ahead = 0;  // s before its end at which the next one may begin (4.1.2)
};

/// Along a straight line (4.1.1). `speed`: mm/s, that at which the slowest axis has its rapid rate.
RapidTime rapid_together(const SpeedRules& rules, const PathShape& shape, double speed);

/// Each axis at its own rapid rate with its own acceleration (4.1.2, INFERRED), the next motion when the slowest one's speed has
/// fallen by N0422 (INFERRED: per cent of the speed).
///   ways   of the axes, mm or degrees, signed
///   rates  their rapid rates, per s
RapidTime rapid_apart(const SpeedRules& rules, const Axes& ways, const Axes& rates);

}  // namespace kadr
