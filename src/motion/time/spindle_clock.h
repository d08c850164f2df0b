#pragma once
// SpindleClock computes the angles of the spindles over the time of the axes' motion. It also stores which spindle is the leading one;
// feeds and threads refer to the leading spindle. The clock receives a spindle command when the command is read, but a motion only when the
// planner emits it. A planned motion therefore keeps the spindle speed that was active when the motion was read.

#include <vector>

#include "action/action.h"
#include "config/setup/setup.h"
#include "motion/least_time/timed_cells.h"
#include "motion/time/spindle_turning.h"

namespace kadr {

class SpindleClock {
 public:
  /// Sets the initial state of a spindle, as TimeEstimate does. The spindle rotates at the speed that the set-up states.
  ///   override_part  spindle override as a factor (1: 100 %)
  void start(const SpindleSetup& setup, double override_part = 1, std::size_t number = 1);

  /// Sets the highest speed of all spindles, rev/min, at which they stay under constant surface speed.
  void limit(double most_rpm);

  /// Makes a spindle the leading spindle. Spindle 1 leads unless the program selects another (nct 11.4).
  ///   pre  all motions planned before this call were emitted
  void select_leading(std::size_t number);
  std::size_t leading() const { return leading_; }

  /// Applies a command to a spindle. INFERRED: the spindle reaches a commanded angle (M19, positioning) at once, because the manuals of the
  /// controls state no time.
  ///   pre  for all commands except a Speed: all motions planned before this call were emitted
  void take(const Action& action);

  /// Couples the rotation of the leading spindle to the axes' travel until release() is called. After release() the spindle is at rest (nct
  /// 18.1.9).
  ///   pre  all motions planned before this call were emitted
  void couple(double degrees_per_mm);
  void release() { per_mm_ = 0; }

  /// Reports the end position of a motion in work coordinates. With constant surface speed, this position determines the spindle speed
  /// after the motion.
  void arrive(const Axes& work) { led().turning.arrive(work); }

  /// The commanded speed of the leading spindle in degrees per second; clockwise is positive. The spindle override is not included, because
  /// threads ignore the override.
  double per_second() const { return turning().degrees(turning().now()); }
  double overridden() const { return override_part_ * per_second(); }
  double override_part() const { return override_part_; }
  const SpindleTurning& turning() const { return spindles_[leading_].turning; }

  /// Returns the rotation of the leading spindle in a cell at the planned speed and advances the clock by the cell's duration. Call it once
  /// for each emitted cell, in the order of the cells.
  SpindleTurn turn(double per_second, const TimeLaw& law);

  /// Returns how long, s, the axes must wait before a motion that synchronises with the spindle. The motion needs `ahead` seconds to
  /// synchronise; after this time the spindle angle is `angle` degrees.
  ///   law  the motion starts after a zero pulse (nct 4.4), and the angle counts from a zero pulse
  ///   pre  the spindle rotates
  double seconds_to(double angle, double ahead) const;

 private:
  struct Turned {
    SpindleTurning turning;
    double angle = 0;       // spindle angle at the end of the last emitted cell, degrees
    bool absolute = false;  // true if the program commanded `angle` (M19, positioning)
  };
  Turned& led() { return spindles_[leading_]; }
  Turned& numbered(std::size_t number);

  std::vector<Turned> spindles_ = std::vector<Turned>(2);  // The index is the spindle number; entry 0 is unused.
  std::size_t leading_ = 1;
  double most_rpm_ = SpindleTurning::fastest;
  double override_part_ = 1;
  double per_mm_ = 0;  // rotation per travel of the axes, degrees/mm, while the leading spindle is coupled to the axes; otherwise 0
};

}  // namespace kadr
