// motion/look_ahead/ramp: closed forms compared with a slow integration. NCT 7.0.

#include "motion/look_ahead/ramp.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/vec.h"

namespace kadr::ramp_test {
namespace {

double within(double low, double high) { return low + (high - low) * *rc::gen::inRange(0, 1'000'001) / 1e6; }

Acceleration any_acceleration() { return {within(10, 5000), *rc::gen::element(0.0, 0.01, 0.05, 0.2), *rc::gen::arbitrary<bool>()}; }

/// Returns the acceleration as 7.0 draws it: it reaches its peak within T, or as far as the change of speed allows.
double drawn(double t, double change, const Acceleration& a) {
  if (a.build_up == 0) return a.most;
  const double jerk = a.most / a.build_up;
  const double peak = std::min(a.most, std::sqrt(change * jerk)), build = peak / jerk, all = change / peak + build;
  const double part = std::clamp(std::min(t, all - t) / build, 0.0, 1.0);
  return peak * (a.jerk_free ? (1 - std::cos(pi * part)) / 2 : part);
}

RC_GTEST_PROP(ramp, is_the_integral_of_the_drawn_acceleration, ()) {
  const Acceleration a = any_acceleration();
  const double from = within(0, 300), to = within(0, 300), sign = to < from ? -1 : 1;
  if (from == to) return;
  const Ramp ramp(from, to, a);
  constexpr int steps = 20'000;
  const double dt = ramp.seconds() / steps;
  double v = from, s = 0;
  for (int i = 0; i < steps; ++i) {
    const double gain = sign * drawn((i + 0.5) * dt, std::abs(to - from), a) * dt;
    s += (v + gain / 2) * dt;
    v += gain;
    if (i % 1000 != 500) continue;
    RC_ASSERT(std::abs(ramp.speed_at((i + 1) * dt) - v) < 1e-4 * 300);
    RC_ASSERT(std::abs(ramp.seconds_at(s) - (i + 1) * dt) * v < 1e-4 * ramp.length());  // at low speed the time is less exact
  }
  RC_ASSERT(std::abs(v - to) < 1e-4 * 300);
  RC_ASSERT(std::abs(s - ramp.length()) < 1e-4 * (1 + s));
}

RC_GTEST_PROP(ramp, reached_is_the_inverse_of_its_length, ()) {
  const Acceleration a = any_acceleration();
  const double from = within(0, 300), length = within(1e-4, 200);
  RC_ASSERT(std::abs(ramp_length(from, reached(from, length, a), a) - length) < 1e-9 * (1 + length));
}

RC_GTEST_PROP(ramp, top_speed_takes_the_whole_way, ()) {
  const Acceleration a = any_acceleration();
  const double from = within(0, 100), length = within(0.1, 200), most = within(1, 400);
  const double to = std::min(within(0, 100), reached(from, length, a));
  if (ramp_length(from, to, a) > length) return;
  const double top = top_speed(from, to, length, most, a);
  const double needs = ramp_length(from, top, a) + ramp_length(top, to, a);
  if (top < most && top > std::max(from, to)) RC_ASSERT(std::abs(needs - length) < 1e-6 * length);
  else RC_ASSERT(needs <= length * (1 + 1e-9));
}

TEST(ramp, from_rest_to_rest) {
  EXPECT_NEAR(travel_seconds(0, 0, 100, 100, {1000}), 1.1, 1e-12);         // F/a + L/F
  EXPECT_NEAR(travel_seconds(0, 0, 2.5, 100, {1000}), 0.1, 1e-12);         // 2·√(L/a)
  EXPECT_NEAR(travel_seconds(0, 0, 100, 100, {1000, 0.05}), 1.15, 1e-12);  // F/a + T + L/F
  const double j = 1000 / 0.05, v = std::cbrt(j / 4);                      // 1 mm < 2·a·T²: (L²·j/4)^⅓
  EXPECT_NEAR(top_speed(0, 0, 1, 100, {1000, 0.05}), v, 1e-9);
  EXPECT_NEAR(travel_seconds(0, 0, 1, 100, {1000, 0.05}), 4 * std::sqrt(v / j), 1e-9);
}

TEST(ramp, without_a_limit_takes_no_time) {
  EXPECT_EQ(travel_seconds(0, 0, 100, 50, {}), 2);
  EXPECT_EQ(Ramp(0, 50, {}).seconds(), 0);
}

}  // namespace
}  // namespace kadr::ramp_test
