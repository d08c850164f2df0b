#pragma once
// SpindleClock: the angle of the spindles over the time of the axes' motion, and of the one that leads: whose turns feeds and threads
// count. Commands reach it when they are read, motions when they are handed out, later: what is planned keeps the rate at which the spindle
// turned when it was read.

#include <vector>

#include "action/action.h"
#include "config/setup.h"
#include "motion/least_time/timed_cells.h"
#include "motion/time/spindle_turning.h"

namespace kadr {

class SpindleClock {
 public:
  /// As TimeEstimate: with the speed that the setup states.
  ///   override_part  spindle override / 100
  void start(const SpindleSetup& setup, double override_part = 1, std::size_t number = 1);

  /// Spindle 1 leads, unless another is said (nct 11.4).
  ///   pre  what was planned before has been handed out
  void lead(std::size_t number);
  std::size_t leading() const { return leading_; }

  /// A command to a spindle. Where its angle is commanded (M19, positioning) it is there at once: INFERRED, the controls state no time.
  ///   pre  of all but a Speed: what was planned before has been handed out
  void take(const Action& action);

  /// From here on it turns with the axes, until released; then it stands (nct 18.1.9).
  ///   pre  what was planned before has been handed out
  void couple(double degrees_per_mm);
  void release() { per_mm_ = 0; }

  /// A motion ends there, work coordinates: with a constant surface speed that tells how fast it turns from there on.
  void arrive(const Axes& work) { led().turning.arrive(work); }

  /// Degrees a second, clockwise, as last commanded: threads know no override.
  double per_second() const { return turning().degrees(turning().now()); }
  double overridden() const { return override_part_ * per_second(); }
  double override_part() const { return override_part_; }
  const SpindleTurning& turning() const { return spindles_[leading_].turning; }

  /// The angle along a cell that is handed out, in order, at the rate that it was planned with.
  SpindleTurn turn(double per_second, const TimeLaw& law);

  /// Waiting time for a motion that takes `ahead` s until it is in step, so that the spindle then has turned by `angle` degrees.
  ///   law  it begins after a zero pulse (nct 4.4), and the angle counts from a zero pulse
  ///   pre  the spindle turns
  double seconds_to(double angle, double ahead) const;

 private:
  struct Turned {
    SpindleTurning turning;
    double angle = 0;       // at the end of what was handed out, degrees
    bool absolute = false;  // it was commanded to an angle
  };
  Turned& led() { return spindles_[leading_]; }
  Turned& numbered(std::size_t number);

  std::vector<Turned> spindles_ = std::vector<Turned>(2);  // by number; 0 is none
  std::size_t leading_ = 1;
  double override_part_ = 1;
  double per_mm_ = 0;  // the leading one is coupled; else 0
};

}  // namespace kadr
