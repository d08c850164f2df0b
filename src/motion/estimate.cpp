#include "motion/estimate.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

/// The setup's entry of the axis, else the one for all axes.
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

}  // namespace

Rates rates_of(const MachineProfile& profile, const Setup& setup, const std::vector<std::string>& axes) {
  Rates rates{{}, setup.feed_override / 100, profile.tool_change_s, profile.spindle_start_s};
  for (std::size_t i = 0; i < std::min(axes.size(), max_axes); ++i)
    rates.rapid[i] = setup.rapid_override / 100 * of_setup(setup, axes[i], &AxisLimits::rapid).value_or(profile_of(profile, axes[i]).rapid);
  return rates;
}

std::pair<double, double> limits_of(const MachineProfile& profile, const Setup& setup, const std::string& axis) {
  const AxisProfile own = profile_of(profile, axis);
  return of_setup(setup, axis, &AxisLimits::limits).value_or(std::pair{own.least, own.most});
}

TimeEstimate::TimeEstimate(const AxisRoles& roles, const Rates& rates) : roles_(roles), rates_(rates) {}

/// All axes together: the slowest decides.
double TimeEstimate::rapid_minutes(const Motion& motion, const Axes& from) const {
  double minutes = 0;
  for (std::size_t i = 0; i < roles_.count; ++i) {
    const double way = std::abs(motion.to[i] - from[i]);
    if (way > 0) minutes = std::max(minutes, way / rates_.rapid[i]);
  }
  return minutes;
}

double TimeEstimate::feed_minutes(const Motion& motion, const Axes& from, double length) const {
  if (motion.unit == FeedUnit::per_min) return 1 / (motion.feed * rates_.feed_part);
  if (length == 0) length = Curve(roles_, from, motion).rotary_length();  // rotary axes alone: degrees for mm
  if (length == 0) return 0;
  const double per_min = motion.unit == FeedUnit::mm_per_rev ? motion.feed * (turning_ ? rpm_ : 0) : motion.feed;
  return length / (per_min * rates_.feed_part);
}

double TimeEstimate::motion(const Motion& motion, const Axes& from, double length) {
  const bool rapid = motion.kind == MotionKind::rapid || (motion.kind == MotionKind::home && motion.feed <= 0);
  const double seconds = 60 * (rapid ? rapid_minutes(motion, from) : feed_minutes(motion, from, length));
  if (!std::isfinite(seconds)) {
    ++split_.unknown;
    return 0;
  }
  (rapid || motion.kind == MotionKind::home ? split_.rapid : split_.cutting) += seconds;
  return seconds;
}

void TimeEstimate::other(const Action& action) {
  if (const auto* dwell = std::get_if<Dwell>(&action.what)) {
    split_.dwell += dwell->seconds;
  } else if (const auto* spindle = std::get_if<Spindle>(&action.what)) {
    const bool starts = spindle->dir == SpindleDir::cw || spindle->dir == SpindleDir::ccw;
    if (starts && !(turning_ && rpm_ > 0)) split_.tool_change += rates_.spindle_start_s;
    turning_ = starts;
    if (starts) rpm_ = spindle->rpm;
  } else if (const auto* speed = std::get_if<Speed>(&action.what)) {
    rpm_ = speed->surface ? 0 : speed->value;
  } else if (std::holds_alternative<ToolChange>(action.what)) {
    split_.tool_change += rates_.tool_change_s;
  }
}

}  // namespace kadr
