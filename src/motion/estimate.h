#pragma once
// Machining time from programmed feeds and the machine's rapid rates: no acceleration yet, so the truth is somewhat longer.

#include "config/machine_profile.h"
#include "config/setup.h"
#include "path/curve.h"

namespace kadr {

/// How fast the machine is, resolved per axis.
struct Rates {
  Axes rapid{};          // mm/min or degrees/min, override included
  double feed_part = 1;  // feed override / 100
  double tool_change_s = 0;
  double spindle_start_s = 0;
};

/// The setup's `machine` and `override` go before the profile.
Rates rates_of(const MachineProfile& profile, const Setup& setup, const std::vector<std::string>& axes);

/// Limits of one axis in machine coordinates; the setup goes before the profile.
std::pair<double, double> limits_of(const MachineProfile& profile, const Setup& setup, const std::string& axis);

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

  /// Of a motion; `length` is Curve::length().
  ///   returns  seconds; 0 if it would never end
  double motion(const Motion& motion, const Axes& from, double length);

  /// Of any other action.
  void other(const Action& action);

  void spindle(double rpm) { rpm_ = rpm; }
  const TimeSplit& split() const { return split_; }

 private:
  double rapid_minutes(const Motion& motion, const Axes& from) const;
  double feed_minutes(const Motion& motion, const Axes& from, double length) const;

  AxisRoles roles_;
  Rates rates_;
  TimeSplit split_;
  double rpm_ = 0;       // commanded
  bool turning_ = true;  // the setup may say that it stands: then rpm_ is 0
};

}  // namespace kadr
