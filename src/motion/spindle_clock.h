#pragma once
// SpindleClock: the angle of the main spindle over the time of the axes' motion. Commands reach it when they are read, motions when
// they are planned, later: what is planned carries a mark that says at which speed.

#include <cstdint>
#include <deque>

#include "config/setup.h"
#include "control/action.h"
#include "motion/spindle_turning.h"
#include "motion/timed_cells.h"

namespace kadr {

class SpindleClock {
 public:
  /// As TimeEstimate: with the speed that the setup states.
  void start(const SpindleSetup& setup);

  /// A command to spindle 1. Where its angle is commanded (M19, positioning) it is there at once: INFERRED, the controls state no time.
  ///   pre  of all but a Speed: what was planned before has been handed out
  void take(const Action& action);

  /// From here on it turns with the axes, until released; then it stands (nct 18.1.9).
  ///   pre  what was planned before has been handed out
  void couple(double degrees_per_mm);
  void release();

  /// To be added to the tags of what is planned now.
  std::uint64_t mark() {
    unmarked_ = false;
    return (last_ & most_marks) << mark_shift;
  }

  /// Adds the angle to cells that are handed out, in order.
  void tell(TimedCells& cells);

  /// Degrees a second, either way.
  double rate() const;

  /// Waiting time for a motion that takes `ahead` s until it is in step, so that the spindle then has turned by `angle` degrees.
  ///   law  it begins behind a zero pulse (nct 4.4), and the angle counts from a zero pulse
  ///   pre  the spindle turns
  double seconds_to(double angle, double ahead) const;

 private:
  static constexpr int mark_shift = 40;  // of tags: below is what AxisMotion tells with them
  static constexpr std::uint64_t most_marks = (std::uint64_t{1} << (64 - mark_shift)) - 1;
  struct Rate {
    std::uint64_t mark;
    double per_second;
  };
  void set_rate();

  SpindleTurning turning_;
  double angle_ = 0;   // at the end of what was handed out, degrees
  double per_mm_ = 0;  // coupled; else 0
  std::uint64_t last_ = 0;
  bool unmarked_ = true;            // nothing is planned at the last speed yet
  std::deque<Rate> rates_{{0, 0}};  // from what is handed out next to the last commanded
};

}  // namespace kadr
