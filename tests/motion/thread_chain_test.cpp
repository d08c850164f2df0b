// Threads synchronous with the spindle: NCT 4.4. The output obeys every
// limit, and between the ramps the axes are where the spindle requires.

#include "motion/least_time/thread_chain.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace kadr::thread_chain_test {
namespace {

constexpr double speed = 200, acceleration = 1000, jerk = 20000;
const MotionLimits limits{{speed, speed}, {acceleration, acceleration}, {jerk, jerk}};

struct Leg {
  double x, z, seconds;
};

ThreadChain chain_of(const std::vector<Leg>& legs) {
  ThreadChain chain(limits);
  chain.begin({});
  for (const Leg& leg : legs) chain.add({leg.x, leg.z}, leg.seconds, 7);
  return chain;
}

/// Returns a cell's polynomial or one of its derivatives by time, at constant speed.
double value(const TimedCells& cells, std::size_t cell, std::size_t axis, double t, int derivative) {
  const double* const c = cells.path.data() + (cell * cells.axes + axis) * TimedCells::terms;
  const double v = cells.laws[cell].v, s = v * t;
  switch (derivative) {
    case 0: return c[0] + s * (c[1] + s * (c[2] + s * c[3]));
    case 1: return v * (c[1] + s * (2 * c[2] + s * 3 * c[3]));
    case 2: return v * v * (2 * c[2] + s * 6 * c[3]);
    default: return v * v * v * 6 * c[3];
  }
}

void expect_within_limits(const TimedCells& cells) {
  constexpr double over = 1 + 1e-9;
  for (std::size_t k = 0; k < cells.laws.size(); ++k)
    for (std::size_t a = 0; a < cells.axes; ++a)
      for (const double t : {0.0, cells.laws[k].seconds}) {
        EXPECT_LE(std::fabs(value(cells, k, a, t, 1)), speed * over);
        EXPECT_LE(std::fabs(value(cells, k, a, t, 2)), acceleration * over);
        EXPECT_LE(std::fabs(value(cells, k, a, t, 3)), jerk * over);
      }
}

void expect_smooth(const TimedCells& cells) {
  const std::array<double, 3> rounding{1e-9, 1e-9, 1e-6};
  for (std::size_t k = 0; k + 1 < cells.laws.size(); ++k)
    for (std::size_t a = 0; a < cells.axes; ++a)
      for (int d = 0; d < 3; ++d)
        EXPECT_NEAR(value(cells, k, a, cells.laws[k].seconds, d), value(cells, k + 1, a, 0, d), rounding[static_cast<std::size_t>(d)]);
}

// By hand: 10 mm/s at 1000 mm/s² and 20,000 mm/s³. 10 < a²/j = 50, so T = 2·√(v/j) = 44.7 ms, and its distance is v·T/2.
TEST(thread_chain, one_thread) {
  const ThreadChain chain = chain_of({{0, -20, 2}});
  const double ramp = 2 * std::sqrt(10.0 / jerk);
  EXPECT_NEAR(chain.ramp(), ramp, 1e-12);
  const TimedCells cells = chain.cells();
  EXPECT_NEAR(cells.seconds(), 2 + ramp, 1e-12);
  double at = -ramp / 2;
  for (std::size_t k = 0; k < cells.laws.size(); at += cells.laws[k++].seconds)
    if (at >= ramp / 2 - 1e-12 && at < 2 - ramp / 2 - 1e-9) {
      EXPECT_NEAR(value(cells, k, 1, 0, 0), -10 * at, 1e-9);
      EXPECT_NEAR(value(cells, k, 1, 0, 1), -10, 1e-9);
    }
  expect_within_limits(cells);
  expect_smooth(cells);
}

// A cone after a cylinder with the same lead: the leading axis is not disturbed.
TEST(thread_chain, the_leading_axis_goes_on_evenly) {
  const ThreadChain chain = chain_of({{0, -20, 2}, {5, -40, 2}});
  const TimedCells cells = chain.cells();
  double at = -chain.ramp() / 2;
  for (std::size_t k = 0; k < cells.laws.size(); at += cells.laws[k++].seconds) {
    if (at > 1 && at < 3) {
      EXPECT_NEAR(value(cells, k, 1, 0, 0), -10 * at, 1e-9);
    }
  }
}

// The spindle requires 400 mm/s: the axis moves as fast as it can.
TEST(thread_chain, faster_than_the_axis) { expect_within_limits(chain_of({{0, -100, 0.25}}).cells()); }

RC_GTEST_PROP(thread_chain, limits_and_ends, ()) {
  std::vector<Leg> legs;
  double x = 0, z = 0;
  for (int i = 0, count = *rc::gen::inRange(1, 12); i < count; ++i) {
    x += *rc::gen::inRange(-500, 500) * 0.01;
    z += *rc::gen::inRange(-500, 500) * 0.01;
    legs.push_back({x, z, *rc::gen::inRange(1, 3000) * 0.001});
  }
  const ThreadChain chain = chain_of(legs);
  if (chain.empty()) return;
  const TimedCells cells = chain.cells();
  expect_within_limits(cells);
  expect_smooth(cells);
  const std::size_t last = cells.laws.size() - 1;
  RC_ASSERT(std::fabs(value(cells, last, 0, cells.laws[last].seconds, 0) - x) < 1e-9);
  RC_ASSERT(std::fabs(value(cells, last, 1, cells.laws[last].seconds, 0) - z) < 1e-9);
  RC_ASSERT(std::fabs(value(cells, last, 1, cells.laws[last].seconds, 1)) < 1e-9);
  RC_ASSERT(std::fabs(cells.seconds() - chain.seconds() - chain.ramp()) < 1e-9);
}

}  // namespace
}  // namespace kadr::thread_chain_test
