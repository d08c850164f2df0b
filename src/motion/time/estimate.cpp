// TimeEstimate computes the machining time from programmed feeds and the machine's rapid rates, without acceleration. Used by machine,
// motion and out; tested by tests/motion/estimate_test.cpp.

#include "motion/time/estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "action/by_kind.h"
#include "base/integral.h"
#include "motion/time/polar_feed.h"

namespace kadr {
namespace {

/// Returns the value that the set-up states for the axis, or otherwise for all axes ("*"); nullopt if the set-up states neither.
template <class T>
std::optional<T> of_setup(const Setup& setup, const std::string& axis, std::optional<T> AxisLimits::*field) {
  for (const std::string& name : {axis, std::string("*")})
    if (const auto found = setup.machine.find(name); found != setup.machine.end() && found->second.*field) return found->second.*field;
  return std::nullopt;
}

AxisProfile profile_of(const MachineProfile& profile, const std::string& axis) {
  const auto found = profile.axes.find(axis);
  return found == profile.axes.end() ? AxisProfile{} : found->second;
}

bool exact_times(const Setup& setup, const std::vector<std::string>& axes) {
  const auto instant = [&](const std::string& axis) {
    const auto found = setup.machine.find(axis);
    return found != setup.machine.end() && found->second.no_acceleration;
  };
  return instant("*") || (!axes.empty() && std::all_of(axes.begin(), axes.end(), instant));
}

}  // namespace

Rates rates_of(const MachineProfile& profile, const Setup& setup, const std::vector<std::string>& axes) {
  Rates rates{{},
              setup.feed_override / 100,
              setup.spindle_override / 100,
              profile.tool_change_s,
              profile.spindle_start_s,
              exact_times(setup, axes)};
  if (const double most = most_rpm_of(profile, setup); most > 0) rates.most_rpm = most;
  for (std::size_t i = 0; i < std::min(axes.size(), max_axes); ++i) {
    rates.most[i] = of_setup(setup, axes[i], &AxisLimits::rapid).value_or(profile_of(profile, axes[i]).rapid);
    rates.rapid[i] = std::min(setup.rapid_override, 100.0) / 100 * rates.most[i];
  }
  return rates;
}

double most_rpm_of(const MachineProfile& profile, const Setup& setup) {
  double most = 0;
  for (const auto& [number, spindle] : setup.spindles)
    for (const auto& [least_of_gear, most_of_gear] : spindle.ranges) most = std::max(most, most_of_gear);
  return most > 0 ? most : profile.most_rpm;
}

double Rates::least_most() const {
  double least = std::numeric_limits<double>::infinity();
  for (const double rate : most)
    if (rate > 0) least = std::min(least, rate);
  return least;
}

/// Finds the axis that needs the longest time at its rapid rate. INFERRED: each axis of the arc's plane counts as moving at the full path
/// speed, which is correct for an arc of a quadrant or more.
SlowestAxis slowest_axis(const AxisRoles& roles, const Curve& curve, const Motion& motion, const Axes& most) {
  SlowestAxis slowest;
  // In polar and cylindrical interpolation the rotary axis limits the feed (polar_feed.h), so the rapid rates of the axes are not compared
  // here.
  if (curve.surface() != PathSurface::plane) return slowest;
  for (std::size_t i = 0; i < roles.count; ++i) {
    const bool turns = !curve.straight() && (i == motion.first || i == motion.second);
    const double travel = turns ? curve.length(motion.along) : std::abs(curve.travel(i));
    if (most[i] > 0 && travel / most[i] > slowest.minutes) slowest = {i, travel / most[i]};
  }
  return slowest;
}

std::pair<double, double> limits_of(const MachineProfile& profile, const Setup& setup, const std::string& axis) {
  const AxisProfile own = profile_of(profile, axis);
  return of_setup(setup, axis, &AxisLimits::limits).value_or(std::pair{own.least, own.most});
}

TimeEstimate::TimeEstimate(const AxisRoles& roles, const Rates& rates)
    : roles_(roles), rates_(rates), lowest_rapid_rate_(rates.least_most()) {
  for (SpindleTurning& spindle : spindles_) spindle.most_rpm = rates.most_rpm;
}

SpindleTurning& TimeEstimate::spindle_of(std::size_t number) {
  while (number >= spindles_.size()) spindles_.emplace_back().most_rpm = rates_.most_rpm;
  return spindles_[number];
}

void TimeEstimate::spindles(const Setup& setup) {
  spindle(setup.spindle().rpm);
  for (const auto& [number, of] : setup.spindles) spindle(of.rpm, static_cast<std::size_t>(number));
}

double& TimeEstimate::share_of(const Motion& motion) {
  return motion.kind == MotionKind::rapid || motion.kind == MotionKind::home ? split_.rapid : split_.cutting;
}

/// Returns the time, min, of a rapid motion in which all axes move together. The slowest axis determines the time.
double TimeEstimate::rapid_minutes(const Curve& curve) const {
  if (curve.surface() == PathSurface::polar) return kadr::rapid_minutes(curve, roles_, rates_.rapid);
  double minutes = 0;
  for (std::size_t i = 0; i < roles_.count; ++i) {
    const double travel = std::abs(curve.travel(i));
    if (travel > 0) minutes = std::max(minutes, travel / rates_.rapid[i]);
  }
  return minutes;
}

/// Returns the time, min, of a thread-cutting motion. The thread lead is the travel per revolution of the axis with the longest travel (nct
/// 4.4). Overrides do not apply to threads.
double TimeEstimate::thread_minutes(const Motion& motion, const Curve& curve) const {
  double longest = 0;
  for (std::size_t i = 0; i < roles_.count; ++i) longest = std::max(longest, std::abs(curve.travel(i)));
  return longest == 0 ? 0 : longest / (*motion.detail->lead * turning(motion).now());
}

/// Returns the time, min, at a feed in mm/rev, for a spindle whose speed depends on the tool's position (nct 11.5).
double TimeEstimate::turning_minutes(const Motion& motion, const Curve& curve, double feed) const {
  constexpr double error = 1e-9;  // greatest relative error of the time that the numerical integration yields
  const SpindleTurning& spindle = turning(motion);
  return integral([&](double part) { return curve.rate(motion.along, part) / (feed * spindle.at(curve.at(part))); }, 0, 1, error);
}

double TimeEstimate::feed_minutes(const Motion& motion, const Curve& curve, MotionTime& time) const {
  const double override_part = motion.own_override ? 1 : rates_.feed_part, spindle_part = motion.own_override ? 1 : rates_.spindle_part;
  const bool measured = time.length > 0 && curve.measures_path(motion.along);
  const double path_length = measured ? time.length : curve.length(motion.along);
  if (motion.unit == FeedUnit::per_min) {
    time.feed = path_length * motion.feed * override_part;
    return 1 / (motion.feed * override_part);
  }
  const bool per_rev = motion.unit == FeedUnit::mm_per_rev;
  time.feed = motion.feed * override_part * (per_rev ? turning(motion).now() * feed_ratio_ * spindle_part : 1);
  if (path_length == 0) return 0;
  if (per_rev && turning(motion).surface.on && curve.surface() == PathSurface::plane) {
    const double minutes = turning_minutes(motion, curve, motion.feed * override_part * spindle_part * feed_ratio_);
    time.feed = path_length / minutes;
    return minutes;
  }
  if (curve.surface() == PathSurface::polar) return minutes(curve, {time.feed, motion.detail->max_rotary_speed, motion.along});
  return path_length / time.feed;
}

/// Returns the time, min, at the programmed feed. The time is long enough that no axis exceeds its rapid rate.
double TimeEstimate::cutting_minutes(const Motion& motion, const Curve& curve, MotionTime& time) const {
  const double minutes = feed_minutes(motion, curve, time);
  if (!(time.feed > lowest_rapid_rate_)) return minutes;
  return std::max(minutes, slowest_axis(roles_, curve, motion, rates_.most).minutes);
}

/// Returns the least time, min, that the machine axes need for their travel. If rotary axes move the tool or the workpiece, the travel of
/// the machine axes differs from the travel in work coordinates (nct 25). The travel is the difference of the end positions.
double TimeEstimate::machine_minutes(const Motion& motion, const ToolPosition& from, bool rapid) const {
  double minutes = 0;
  for (std::size_t i = 0; i < roles_.count; ++i) {
    const double rate = rapid ? rates_.rapid[i] : rates_.most[i];
    const bool rolled = motion.detail && (motion.detail->rolled >> i & 1U) != 0;
    const double travel = std::abs(rolled ? motion.detail->travel[i] : motion.machine[i] - from.machine[i]);
    if (travel > 0 && rate > 0) minutes = std::max(minutes, travel / rate);
  }
  return minutes;
}

MotionTime TimeEstimate::motion(const Motion& motion, const Curve& curve, const ToolPosition* from) {
  const bool rapid = motion.kind == MotionKind::rapid || (motion.kind == MotionKind::home && motion.feed <= 0);
  const bool thread = motion.kind == MotionKind::thread && motion.detail && motion.detail->lead;
  MotionTime time;
  time.length = curve.length();
  double minutes = rapid ? rapid_minutes(curve) : thread ? thread_minutes(motion, curve) : cutting_minutes(motion, curve, time);
  if (from != nullptr && from->space && !from->space->is_plain()) minutes = std::max(minutes, machine_minutes(motion, *from, rapid));
  if (turning(motion).surface.on) spindle_of(motion.spindle).arrive(curve.at(1));
  if (!std::isfinite(minutes)) {
    ++split_.unknown;
    return time;
  }
  time.seconds = 60 * minutes;
  share_of(motion) += time.seconds;
  if (!rates_.exact_times) return time;
  time.exact = true;
  const bool polar = curve.surface() == PathSurface::polar;
  if (polar && !rapid && motion.unit != FeedUnit::per_min)
    time.feed_most = highest_feed(curve, {time.feed, motion.detail->max_rotary_speed, motion.along});
  else if (minutes > 0 && !(polar && rapid)) time.feed_most = curve.length(motion.along) / minutes;
  return time;
}

void TimeEstimate::other(const Action& action) {
  by_kind(
      action, [&](const Dwell& dwell) { split_.dwell += dwell.seconds; },
      [&](const Spindle& spindle) {
        SpindleTurning& turning = spindle_of(spindle.number);
        const bool stood = !(turning.now() > 0);
        turning.take(spindle);
        if (turning.on && stood) split_.tool_change += rates_.spindle_start_s;
      },
      [&](const Speed& speed) { spindle_of(speed.number).take(speed); },
      [&](const SurfaceSpeed& law) { spindle_of(law.number).surface = law; },
      [&](const Couple& couple) { feed_ratio_ = couple.feeds_by_slave ? std::abs(couple.ratio) : 1; },
      [&](const Uncouple&) { feed_ratio_ = 1; },
      [&](const ToolChange& change) {
        if (!change.there) split_.tool_change += rates_.tool_change_s;
      },
      ignores<Motion, CoolantSwitch, ToolSelect, MachineFunction, AuxiliaryFunction, Stop, Message, FrameChange, Sync, ZoneChange,
              CompensationBreak, CompensationCorner, CompensationCheck>);
}

/// Computes the time of a step. The pause of a step is the increase of the time sums, so that the pauses of all steps add up exactly to
/// these sums.
void TimeEstimate::time(Step& step) {
  if (const Motion* const moved = step.motion()) {
    step.time = motion(*moved, step.curve(), &step.from);
    return;
  }
  const double dwell = split_.dwell, tool_change = split_.tool_change;
  other(step.action);
  step.pause = split_.dwell + split_.tool_change - dwell - tool_change;
}

}  // namespace kadr
