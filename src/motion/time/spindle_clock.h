#pragma once
// SpindleClock: the angle of the spindles over the time of the axes' motion, and which of them leads: feeds and threads refer to the
// leading spindle. Commands arrive when they are read, motions later, when they are emitted: what is planned keeps the rate that the
// spindle had when the motion was read.

#include <vector>

#include "action/action.h"
#include "config/setup.h"
#include "motion/least_time/timed_cells.h"
#include "motion/time/spindle_turning.h"

namespace kadr {

class SpindleClock {
 public:
  /// Sets a spindle's state at the start, as TimeEstimate does: it runs at the speed that the set-up states.
  ///   override_part  spindle override / 100
  void start(const SpindleSetup& setup, double override_part = 1, std::size_t number = 1);

  /// Makes a spindle the leading one. Spindle 1 leads unless the program selects another (nct 11.4).
  ///   pre  everything planned before was emitted
  void lead(std::size_t number);
  std::size_t leading() const { return leading_; }

  /// Applies a command to a spindle. A commanded angle (M19, positioning) is reached at once: INFERRED, the controls state no time.
  ///   pre  for all commands but a Speed: everything planned before was emitted
  void take(const Action& action);

  /// Couples the leading spindle to the axes until release(); after that it is at rest (nct 18.1.9).
  ///   pre  everything planned before was emitted
  void couple(double degrees_per_mm);
  void release() { per_mm_ = 0; }

  /// Reports the end of a motion, work coordinates: with constant surface speed it determines the spindle speed from there on.
  void arrive(const Axes& work) { led().turning.arrive(work); }

  /// Degrees per second, clockwise, as last commanded, without override: threads ignore it.
  double per_second() const { return turning().degrees(turning().now()); }
  double overridden() const { return override_part_ * per_second(); }
  double override_part() const { return override_part_; }
  const SpindleTurning& turning() const { return spindles_[leading_].turning; }

  /// Returns the angle along a cell at the planned rate and advances the clock. Call it for the emitted cells, in order.
  SpindleTurn turn(double per_second, const TimeLaw& law);

  /// Returns the waiting time, s, before a motion that takes `ahead` s to synchronise, so that the spindle has then turned by `angle`
  /// degrees.
  ///   law  the motion starts after a zero pulse (nct 4.4), and the angle counts from a zero pulse
  ///   pre  the spindle rotates
  double seconds_to(double angle, double ahead) const;

 private:
  struct Turned {
    SpindleTurning turning;
    double angle = 0;       // at the end of what was emitted, degrees
    bool absolute = false;  // the angle was commanded
  };
  Turned& led() { return spindles_[leading_]; }
  Turned& numbered(std::size_t number);

  std::vector<Turned> spindles_ = std::vector<Turned>(2);  // by number; 0 is unused
  std::size_t leading_ = 1;
  double override_part_ = 1;
  double per_mm_ = 0;  // degrees per mm while the leading spindle is coupled, else 0
};

}  // namespace kadr
