#pragma once
// MotionTime: the length and the duration of a motion, computed by motion/time/estimate or by motion/look_ahead.

#include <optional>

namespace kadr {

/// The length, duration and speeds of one motion.
struct MotionTime {
  double length = 0;   // length of the path as Curve::length() returns it, mm
  double seconds = 0;  // duration, s; 0 if the motion would never end
  // Commanded feed after override, mm/min or degrees/min, measured along MotionFeed::along; 0: a rapid, or a motion without feed
  double feed = 0;
  double feed_most = 0;  // highest speed of the motion, in the unit of `feed`; valid only if `exact` (0 for a rapid in polar interpolation)
  bool exact = false;    // `seconds` is the exact time of the machine's motion plan, not an estimate
  std::optional<double> feed_end{};  // speed at the end of the motion, in the unit of `feed`; set if the look-ahead has planned it
};

}  // namespace kadr
