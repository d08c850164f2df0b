#pragma once
// TimeEstimate computes the machining time from programmed feeds and the machine's rapid rates, without acceleration.
// motion/look_ahead/look_ahead.h computes the time with acceleration.

#include "action/step.h"
#include "config/machine/machine_profile.h"
#include "config/setup/setup.h"
#include "motion/time/spindle_turning.h"

namespace kadr {

/// The rapid rates of the axes, the overrides and the times of the machine's functions.
struct Rates {
  Axes rapid{};             // rapid rate of each axis, mm/min or degrees/min; the rapid override is included
  double feed_part = 1;     // feed override as a factor (1: 100 %)
  double spindle_part = 1;  // spindle override as a factor (1: 100 %)
  double tool_change_s = 0;
  double spindle_start_s = 0;
  bool exact_times = false;  // true: the axes accelerate instantly, so the estimate is exact
  // highest spindle speed, rev/min, at which the spindle stays under constant surface speed
  double most_rpm = SpindleTurning::fastest;
  Axes most{};  // rapid rate of each axis without the rapid override, mm/min or degrees/min; 0: the rate is unknown
  /// Returns the lowest known rate in `most`, mm/min. A motion at this feed or a lower feed cannot exceed the rate of any axis.
  double least_most() const;
};

/// Returns the rates from the set-up and the machine profile. The fields `machine` and `override` of the set-up have priority. The times
/// are exact if the set-up states `"acceleration": null` for "*" or for every axis.
Rates rates_of(const MachineProfile& profile, const Setup& setup, const std::vector<std::string>& axes);

/// Returns the least and the greatest position of one axis in machine coordinates. The set-up has priority over the machine profile.
std::pair<double, double> limits_of(const MachineProfile& profile, const Setup& setup, const std::string& axis);

/// Returns the highest spindle speed, rev/min, that the set-up states for the spindle's gears, or else that the machine's file states; 0 if
/// neither states one.
double most_rpm_of(const MachineProfile& profile, const Setup& setup);

/// The axis of a motion that needs the longest time at its rapid rate. No feed can make the motion shorter than this time.
struct SlowestAxis {
  std::size_t axis = 0;
  double minutes = 0;
};
SlowestAxis slowest_axis(const AxisRoles& roles, const Curve& curve, const Motion& motion, const Axes& most);

/// Sums of time in s, one sum for each activity.
struct TimeSplit {
  double cutting = 0;
  double rapid = 0;
  double dwell = 0;
  double tool_change = 0;  // tool change times and spindle start times, s
  // Number of motions that would never end, because there is no feed, the spindle is at rest or the override is 0. The sums do not include
  // these motions.
  std::uint64_t unknown = 0;
  double total() const { return cutting + rapid + dwell + tool_change; }
};

/// Adds up the times of Actions. The caller must give the Actions in program order.
class TimeEstimate {
 public:
  TimeEstimate(const AxisRoles& roles, const Rates& rates);

  /// Computes the time of a motion along its curve and adds the time to the sum.
  ///   from  the axes' position before the motion; nullptr: the start of the curve
  MotionTime motion(const Motion& motion, const Curve& curve, const ToolPosition* from = nullptr);

  /// Adds the time of an action that is not a motion. A Sync, which waits for another channel, adds no time.
  void other(const Action& action);

  /// Computes the time of a step, whatever its action is, and stores the time in the step.
  void time(Step& step);

  /// Adds `longer`, s, to the sum after the look-ahead has planned a motion. A negative value means that the motion takes less than its
  /// programmed time.
  void lengthen(const Motion& motion, double longer) { share_of(motion) += longer; }

  void spindle(double rpm, std::size_t number = 1) { spindle_of(number).rpm = rpm; }
  /// Sets the spindle speeds that the set-up states.
  void spindles(const Setup& setup);
  const TimeSplit& split() const { return split_; }
  /// Resets the time sums to zero. The spindles keep their states.
  void start_over() { split_ = {}; }
  /// Returns the spindle whose revolutions determine the motion's feed or thread (nct 11.4).
  const SpindleTurning& turning(const Motion& motion) const { return spindles_[motion.spindle < spindles_.size() ? motion.spindle : 0]; }

 private:
  double& share_of(const Motion& motion);
  SpindleTurning& spindle_of(std::size_t number);
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
  // Ratio for feed per revolution with an electronic gearbox: revolutions of the slave axis per spindle revolution.
  double feed_ratio_ = 1;
  // The index is the spindle number; entry 0 is used only if a motion has an unknown spindle.
  std::vector<SpindleTurning> spindles_ = std::vector<SpindleTurning>(2);
};

}  // namespace kadr
