#pragma once
// MotionTime: how long a motion is and how long it takes, by motion/time/estimate or motion/look_ahead.

#include <optional>

namespace kadr {

/// What was found of one motion.
struct MotionTime {
  double length = 0;                 // Curve::length(), mm
  double seconds = 0;                // 0 if it would never end
  double feed = 0;                   // the commanded one after override, mm/min (degrees/min), along what `along` says; 0: rapid, none
  double feed_most = 0;              // highest speed along that, where `exact` (0 of a rapid in polar interpolation)
  bool exact = false;                // the seconds are those of the machine
  std::optional<double> feed_end{};  // speed at its end, as feed_most; where the look-ahead has planned it
};

}  // namespace kadr
