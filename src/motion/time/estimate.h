#pragma once
// Computes the machining time from programmed feeds and the machine's rapid rates, without acceleration. motion/look_ahead/look_ahead.h
// computes it with acceleration.

#include "action/step.h"
#include "config/machine/machine_profile.h"
#include "config/setup/setup.h"
#include "motion/time/spindle_turning.h"

namespace kadr {

/// The speeds of the machine, per axis.
struct Rates {
  Axes rapid{};             // rapid rate of each axis, mm/min or degrees/min, override included
  double feed_part = 1;     // feed override as a share (1: 100 %)
  double spindle_part = 1;  // spindle override as a share (1: 100 %)
  double tool_change_s = 0;
  double spindle_start_s = 0;
  bool exact_times = false;  // true: the axes accelerate instantly, so the estimate is exact
  Axes most{};               // rapid rate of each axis without override, mm/min or degrees/min; 0: unknown
  /// Returns the lowest known rate in `most`. A motion at this feed or less cannot exceed the rate of any axis.
  double least_most() const;
};

/// Reads the rates from set-up and profile; the set-up's `machine` and `override` have priority. Times are exact if the set-up states
/// `"acceleration": null` for "*" or for every axis.
Rates rates_of(const MachineProfile& profile, const Setup& setup, const std::vector<std::string>& axes);

/// Returns the travel limits of one axis in machine coordinates (least, most); the set-up has priority over the profile.
std::pair<double, double> limits_of(const MachineProfile& profile, const Setup& setup, const std::string& axis);

/// The axis of a motion that needs the longest time at its rapid rate. No feed can make the motion shorter than this time.
struct SlowestAxis {
  std::size_t axis = 0;
  double minutes = 0;
};
SlowestAxis slowest_axis(const AxisRoles& roles, const Curve& curve, const Motion& motion, const Axes& most);

/// Sums of time in seconds, by what the time was spent on.
struct TimeSplit {
  double cutting = 0;
  double rapid = 0;
  double dwell = 0;
  double tool_change = 0;     // includes spindle start times
  std::uint64_t unknown = 0;  // number of motions that would never end (no feed, spindle at rest, override 0); not included in the times
  double total() const { return cutting + rapid + dwell + tool_change; }
};

/// Adds up the times of Actions, which must be given in program order.
class TimeEstimate {
 public:
  TimeEstimate(const AxisRoles& roles, const Rates& rates);

  /// Computes the time of a motion along its curve and adds it to the sum.
  ///   from  the axes' position before the motion; nullptr: the start of the curve
  MotionTime motion(const Motion& motion, const Curve& curve, const ToolPosition* from = nullptr);

  /// Adds the time of an action that is not a motion. A Sync (wait for another channel) adds no time.
  void other(const Action& action);

  /// Computes the time of a step of any type and stores it in the step.
  void time(Step& step);

  /// Adds `longer`, s, to the sum when the look-ahead has planned a motion; negative: the motion takes less than its programmed time.
  void lengthen(const Motion& motion, double longer) { share_of(motion) += longer; }

  void spindle(double rpm, std::size_t number = 1) { spindle_of(number).rpm = rpm; }
  /// Sets the spindle speeds that the set-up states.
  void spindles(const Setup& setup);
  const TimeSplit& split() const { return split_; }
  /// Resets the times to zero; the state of the spindles is kept.
  void start_over() { split_ = {}; }

 private:
  double& share_of(const Motion& motion);
  SpindleTurning& spindle_of(std::size_t number);
  /// Returns the spindle to whose revolutions the motion's feed or thread refers (nct 11.4).
  const SpindleTurning& turning(const Motion& motion) const { return spindles_[motion.spindle < spindles_.size() ? motion.spindle : 0]; }
  double rapid_minutes(const Curve& curve) const;
  double machine_minutes(const Motion& motion, const ToolPosition& from, bool rapid) const;
  double thread_minutes(const Motion& motion, const Curve& curve) const;
  double feed_minutes(const Motion& motion, const Curve& curve, MotionTime& time) const;
  double cutting_minutes(const Motion& motion, const Curve& curve, MotionTime& time) const;
  double turning_minutes(const Motion& motion, const Curve& curve, double feed) const;

  AxisRoles roles_;
  Rates rates_;
  double lowest_rapid_rate_;
  TimeSplit split_;
  double feed_ratio_ = 1;  // for feed per revolution with an electronic gearbox: revolutions of the slave axis per spindle revolution
  std::vector<SpindleTurning> spindles_ = std::vector<SpindleTurning>(2);  // index: spindle number; entry 0 is unused
};

}  // namespace kadr
