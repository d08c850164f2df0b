#pragma once
// SpindleClock: computes the angles of the spindles over the time of the axes' motion, and stores which spindle is the leading one: feeds
// and threads refer to the leading spindle. Spindle commands arrive when they are read, but motions arrive later, when they are emitted.
// A planned motion therefore keeps the spindle speed that was active when the motion was read.

#include <vector>

#include "action/action.h"
#include "config/setup/setup.h"
#include "motion/least_time/timed_cells.h"
#include "motion/time/spindle_turning.h"

namespace kadr {

class SpindleClock {
 public:
  /// Sets a spindle's initial state, as TimeEstimate does: the spindle rotates at the speed that the set-up states.
  ///   override_part  spindle override as a share (1: 100 %)
  void start(const SpindleSetup& setup, double override_part = 1, std::size_t number = 1);

  /// Makes a spindle the leading one. Spindle 1 leads unless the program selects another (nct 11.4).
  ///   pre  all motions planned before this call were emitted
  void lead(std::size_t number);
  std::size_t leading() const { return leading_; }

  /// Applies a command to a spindle. A commanded angle (M19, positioning) is reached at once: INFERRED, the controls state no time.
  ///   pre  for all commands but a Speed: all motions planned before this call were emitted
  void take(const Action& action);

  /// Couples the leading spindle's rotation to the axes' travel until release(); after release() the spindle is at rest (nct 18.1.9).
  ///   pre  all motions planned before this call were emitted
  void couple(double degrees_per_mm);
  void release() { per_mm_ = 0; }

  /// Reports the end position of a motion, work coordinates. With constant surface speed, this position determines the spindle speed
  /// after the motion.
  void arrive(const Axes& work) { led().turning.arrive(work); }

  /// Commanded speed of the leading spindle, degrees per second, clockwise positive. The spindle override is not included, because
  /// threads ignore it.
  double per_second() const { return turning().degrees(turning().now()); }
  double overridden() const { return override_part_ * per_second(); }
  double override_part() const { return override_part_; }
  const SpindleTurning& turning() const { return spindles_[leading_].turning; }

  /// Returns the spindle angle in a cell at the planned speed and advances the clock by the cell's duration. Call it for the emitted
  /// cells, in order.
  SpindleTurn turn(double per_second, const TimeLaw& law);

  /// Returns how long the axes must wait, s, before a motion that takes `ahead` s to synchronise, so that the spindle angle is then
  /// `angle` degrees.
  ///   law  the motion starts after a zero pulse (nct 4.4), and the angle counts from a zero pulse
  ///   pre  the spindle rotates
  double seconds_to(double angle, double ahead) const;

 private:
  struct Turned {
    SpindleTurning turning;
    double angle = 0;       // spindle angle at the end of the last emitted cell, degrees
    bool absolute = false;  // true if `angle` was commanded (M19, positioning)
  };
  Turned& led() { return spindles_[leading_]; }
  Turned& numbered(std::size_t number);

  std::vector<Turned> spindles_ = std::vector<Turned>(2);  // index: spindle number; entry 0 is unused
  std::size_t leading_ = 1;
  double override_part_ = 1;
  double per_mm_ = 0;  // rotation per axis travel, degrees/mm, while the leading spindle is coupled to the axes, else 0
};

}  // namespace kadr
