#pragma once
// MotionTime: the length and the duration of a motion, as computed by motion/time/estimate or motion/look_ahead.

#include <optional>

namespace kadr {

/// The length, duration and speeds of one motion.
struct MotionTime {
  double length = 0;     // Curve::length(), mm
  double seconds = 0;    // duration; 0 if the motion would never end
  double feed = 0;       // the commanded feed after override, mm/min (degrees/min), measured along MotionFeed::along; 0: rapid, or no feed
  double feed_most = 0;  // highest speed, in the unit of `feed`; valid only if `exact` (0 for a rapid in polar interpolation)
  bool exact = false;    // `seconds` is the machine's exact time, not an estimate
  std::optional<double> feed_end{};  // speed at the end, in the unit of `feed`; set if the look-ahead has planned it
};

}  // namespace kadr
