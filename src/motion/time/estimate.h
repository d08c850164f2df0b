#pragma once
// Machining time from programmed feeds and the machine's rapid rates, without acceleration; with it: motion/look_ahead/look_ahead.h.

#include "action/step.h"
#include "config/machine_profile.h"
#include "config/setup.h"
#include "motion/time/spindle_turning.h"

namespace kadr {

/// How fast the machine is, resolved per axis.
struct Rates {
  Axes rapid{};             // mm/min or degrees/min, override included
  double feed_part = 1;     // feed override / 100
  double spindle_part = 1;  // spindle override / 100
  double tool_change_s = 0;
  double spindle_start_s = 0;
  bool exact_times = false;  // the axes take no time to speed up: the estimate is the truth
  Axes most{};               // of each axis, mm/min or degrees/min: its rapid rate without override; 0: not known
  /// The least of them: a motion at no more needs no closer look.
  double least_most() const;
};

/// The setup's `machine` and `override` go before the profile. Times are exact if the setup says `"acceleration": null` for "*"
/// or for every axis.
Rates rates_of(const MachineProfile& profile, const Setup& setup, const std::vector<std::string>& axes);

/// Limits of one axis in machine coordinates; the setup goes before the profile.
std::pair<double, double> limits_of(const MachineProfile& profile, const Setup& setup, const std::string& axis);

/// The axis that takes longest at its rapid rate: no feed makes the motion shorter.
struct SlowestAxis {
  std::size_t axis = 0;
  double minutes = 0;
};
SlowestAxis slowest_axis(const AxisRoles& roles, const Curve& curve, const Motion& motion, const Axes& most);

/// Seconds, by what they were spent on.
struct TimeSplit {
  double cutting = 0;
  double rapid = 0;
  double dwell = 0;
  double tool_change = 0;     // and starts of the spindle
  std::uint64_t unknown = 0;  // motions that would never end: no feed, spindle stands, override 0; not in the times
  double total() const { return cutting + rapid + dwell + tool_change; }
};

/// Adds up the time of Actions in order.
class TimeEstimate {
 public:
  TimeEstimate(const AxisRoles& roles, const Rates& rates);

  /// Of a motion along its curve.
  ///   from  where the axes stand; nullptr: as the curve begins
  MotionTime motion(const Motion& motion, const Curve& curve, const ToolPosition* from = nullptr);

  /// Of any other action. A Sync takes no time of its own.
  void other(const Action& action);

  /// Of any: the step is told when it happens.
  void time(Step& step);

  /// A motion takes `longer` than its programmed time, s: the look-ahead has planned it.
  void lengthen(const Motion& motion, double longer) { share_of(motion) += longer; }

  void spindle(double rpm, std::size_t number = 1) { spindle_of(number).rpm = rpm; }
  /// As the set-up says that they turn.
  void spindles(const Setup& setup);
  const TimeSplit& split() const { return split_; }
  /// Counts from zero; how the spindles turn is kept.
  void start_over() { split_ = {}; }

 private:
  double& share_of(const Motion& motion);
  SpindleTurning& spindle_of(std::size_t number);
  /// The spindle whose turns the motion's feed or thread counts (nct 11.4).
  const SpindleTurning& turning(const Motion& motion) const { return spindles_[motion.spindle < spindles_.size() ? motion.spindle : 0]; }
  double rapid_minutes(const Curve& curve) const;
  double machine_minutes(const Motion& motion, const ToolPosition& from, bool rapid) const;
  double thread_minutes(const Motion& motion, const Curve& curve) const;
  double feed_minutes(const Motion& motion, const Curve& curve, MotionTime& time) const;
  double cutting_minutes(const Motion& motion, const Curve& curve, MotionTime& time) const;
  double turning_minutes(const Motion& motion, const Curve& curve, double feed) const;

  AxisRoles roles_;
  Rates rates_;
  double least_most_;
  TimeSplit split_;
  double feed_ratio_ = 1;  // feed per revolution: of a gearbox's slave for one of the spindle
  std::vector<SpindleTurning> spindles_ = std::vector<SpindleTurning>(2);  // by number; 0 is none
};

}  // namespace kadr
