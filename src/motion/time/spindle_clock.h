#pragma once
// SpindleClock: the angle of the main spindle over the time of the axes' motion. Commands reach it when they are read, motions when
// they are handed out, later: what is planned keeps the rate at which the spindle turned when it was read.

#include "action/action.h"
#include "config/setup.h"
#include "motion/least_time/timed_cells.h"
#include "motion/time/spindle_turning.h"

namespace kadr {

class SpindleClock {
 public:
  /// As TimeEstimate: with the speed that the setup states.
  ///   override_part  spindle override / 100
  void start(const SpindleSetup& setup, double override_part = 1);

  /// A command to spindle 1. Where its angle is commanded (M19, positioning) it is there at once: INFERRED, the controls state no time.
  ///   pre  of all but a Speed: what was planned before has been handed out
  void take(const Action& action);

  /// From here on it turns with the axes, until released; then it stands (nct 18.1.9).
  ///   pre  what was planned before has been handed out
  void couple(double degrees_per_mm);
  void release() { per_mm_ = 0; }

  /// A motion ends there, work coordinates: with a constant surface speed that tells how fast it turns from there on.
  void arrive(const Axes& work) { turning_.arrive(work); }

  /// Degrees a second, clockwise, as last commanded: threads know no override.
  double per_second() const { return turning_.degrees(turning_.now()); }
  double overridden() const { return override_part_ * per_second(); }
  double override_part() const { return override_part_; }
  const SpindleTurning& turning() const { return turning_; }

  /// The angle along a cell that is handed out, in order, at the rate that it was planned with.
  SpindleTurn turn(double per_second, const TimeLaw& law);

  /// Waiting time for a motion that takes `ahead` s until it is in step, so that the spindle then has turned by `angle` degrees.
  ///   law  it begins after a zero pulse (nct 4.4), and the angle counts from a zero pulse
  ///   pre  the spindle turns
  double seconds_to(double angle, double ahead) const;

 private:
  SpindleTurning turning_;
  double override_part_ = 1;
  double angle_ = 0;       // at the end of what was handed out, degrees
  double per_mm_ = 0;      // coupled; else 0
  bool absolute_ = false;  // it was commanded to an angle
};

}  // namespace kadr
