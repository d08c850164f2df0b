// This file computes the feed of polar interpolation. Near the rotation centre the speed limit of the rotary axis reduces the feed. Used by
// motion and out; tested by tests/motion/polar_feed_test.cpp.

#include "motion/time/polar_feed.h"

#include <algorithm>
#include <cmath>

#include "base/integral.h"

namespace kadr {
namespace {

constexpr double time_error = 1e-9;  // greatest relative error of the integrated time: less than a millisecond in a week of machining

/// Integrates a function of the position over the motion. The integrand has its peak near the rotation centre, where the rotary axis is
/// fastest. The motion is therefore divided at the peak, and each half is integrated separately.
template <class F>
double over_motion(const Curve& curve, const F& minutes_per_part) {
  const double nearest = curve.nearest();
  double sum = 0;
  if (nearest > 0) sum += integral(minutes_per_part, 0, nearest, time_error);
  if (nearest < 1) sum += integral(minutes_per_part, nearest, 1, time_error);
  return sum;
}

double rotary_rate(const Curve& curve, double part) { return std::abs(curve.polar_rates(part).rotary); }

}  // namespace

double minutes_per_part(const Curve& curve, const PolarFeed& limits, double part) {
  const double free = curve.rate(limits.along, part) / limits.feed;
  return limits.max_rotary_speed > 0 ? std::max(free, rotary_rate(curve, part) / limits.max_rotary_speed) : free;
}

double feed_at(const Curve& curve, const PolarFeed& limits, double part) {
  const double rate = curve.rate(limits.along, part);
  return rate == 0 ? limits.feed : std::min(limits.feed, rate / minutes_per_part(curve, limits, part));
}

double highest_feed(const Curve& curve, const PolarFeed& limits) {
  double highest = 0;
  for (int i = 0; i <= curve.samples(); ++i) highest = std::max(highest, feed_at(curve, limits, double(i) / curve.samples()));
  return highest;
}

double minutes(const Curve& curve, const PolarFeed& limits) {
  if (limits.max_rotary_speed <= 0) return curve.length(limits.along) / limits.feed;
  return over_motion(curve, [&](double part) { return minutes_per_part(curve, limits, part); });
}

double rapid_minutes_per_part(const Curve& curve, const AxisRoles& roles, const Axes& rapid, double part) {
  const Axes rates = curve.rates(part);
  double slowest = 0;
  for (std::size_t i = 0; i < roles.count; ++i)
    if (rates[i] != 0) slowest = std::max(slowest, std::abs(rates[i]) / rapid[i]);
  return slowest;
}

double rapid_minutes(const Curve& curve, const AxisRoles& roles, const Axes& rapid) {
  return over_motion(curve, [&](double part) { return rapid_minutes_per_part(curve, roles, rapid, part); });
}

}  // namespace kadr
