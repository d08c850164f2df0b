// motion/look_ahead/speed_plan: no limit is exceeded, and the division of a path into segments does not matter. NCT 7.0.2.

#include "motion/look_ahead/speed_plan.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace kadr::speed_plan_test {
namespace {

double within(double low, double high) { return low + (high - low) * *rc::gen::resize(100, rc::gen::inRange(0, 1'000'001)) / 1e6; }

std::vector<PathPiece> any_path(bool smooth) {
  std::vector<PathPiece> pieces(static_cast<std::size_t>(*rc::gen::inRange(1, 30)));
  const double most = within(10, 200);
  const bool jerk_free = *rc::gen::arbitrary<bool>();
  for (PathPiece& p : pieces) {
    p.length = *rc::gen::element(0.01, 0.1, 1.0, 20.0) * within(0.5, 2);
    p.most = *rc::gen::arbitrary<bool>() ? most : within(5, 200);
    p.enter = *rc::gen::arbitrary<bool>() ? 1e9 : within(0, 200);
    p.acceleration = {within(100, 2000), smooth ? *rc::gen::element(0.02, 0.1) : 0, jerk_free};
  }
  return pieces;
}

double seconds(std::vector<PathPiece> pieces) {
  SpeedPlan().make(pieces, 0);
  double sum = 0;
  for (const PathPiece& p : pieces) sum += p.seconds;
  return sum;
}

/// Reverses a path: the speed that was allowed at the start of a segment is now allowed at its end.
std::vector<PathPiece> reversed(std::vector<PathPiece> pieces) {
  for (std::size_t k = 0; k < pieces.size(); ++k) pieces[k].enter = k + 1 < pieces.size() ? pieces[k + 1].enter : 1e9;
  std::reverse(pieces.begin(), pieces.end());
  return pieces;
}

void check_limits(bool smooth) {
  std::vector<PathPiece> pieces = any_path(smooth);
  SpeedPlan().make(pieces, 0);
  constexpr double slack = 1 + 1e-9;
  double start = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const PathPiece& p = pieces[k];
    RC_ASSERT(p.top <= p.most * slack);
    RC_ASSERT(std::max(start, p.end) <= p.top * slack);
    if (k + 1 < pieces.size()) RC_ASSERT(p.end <= pieces[k + 1].enter * slack + 1e-12);
    RC_ASSERT(std::abs(p.end * p.end - start * start) <= 2 * p.acceleration.most * p.length * slack + 1e-9);
    RC_ASSERT(p.seconds >= p.length / p.top / slack);
    start = p.end;
  }
  RC_ASSERT(start == 0);
}

RC_GTEST_PROP(speed_plan, linear_within_limits, ()) { check_limits(false); }
RC_GTEST_PROP(speed_plan, bell_shaped_within_limits, ()) { check_limits(true); }

RC_GTEST_PROP(speed_plan, backwards_it_takes_the_same_time, ()) {
  const std::vector<PathPiece> pieces = any_path(false);
  const double there = seconds(pieces), back = seconds(reversed(pieces));
  RC_ASSERT(std::abs(there - back) <= 1e-9 * there);
}

RC_GTEST_PROP(speed_plan, cut_in_two_it_takes_the_same_time, ()) {
  std::vector<PathPiece> pieces = any_path(*rc::gen::arbitrary<bool>());
  const double whole = seconds(pieces);
  const auto at = *rc::gen::inRange<std::size_t>(0, pieces.size());
  PathPiece second = pieces[at];
  const double part = within(0.01, 0.99);
  second.length *= 1 - part;
  second.enter = 1e9;
  pieces[at].length *= part;
  pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(at) + 1, second);
  RC_ASSERT(std::abs(seconds(pieces) - whole) <= 1e-9 * whole);
}

RC_GTEST_PROP(speed_plan, bell_shaped_takes_longer, ()) {
  std::vector<PathPiece> pieces = any_path(true);
  const double smooth = seconds(pieces);
  for (PathPiece& p : pieces) p.acceleration.build_up = 0;
  RC_ASSERT(seconds(pieces) <= smooth * (1 + 1e-9));
}

/// Limits that are equal except for rounding, as along the sides of a figure: it must not matter which of them is lower.
RC_GTEST_PROP(speed_plan, rounding_decides_nothing, ()) {
  const std::vector<PathPiece> even = any_path(true);
  std::vector<PathPiece> planned = even, noisy = even;
  for (PathPiece& p : noisy) {
    p.most *= 1 + 1e-15 * *rc::gen::inRange(-4, 5);
    p.enter *= 1 + 1e-15 * *rc::gen::inRange(-4, 5);
  }
  SpeedPlan().make(planned, 0);
  SpeedPlan().make(noisy, 0);
  for (std::size_t k = 0; k < even.size(); ++k)
    RC_ASSERT(std::abs(planned[k].seconds - noisy[k].seconds) <= 1e-5 * std::max(planned[k].seconds, noisy[k].seconds));
}

TEST(speed_plan, one_ramp_over_many_pieces) {
  const std::vector<PathPiece> pieces(100, {1, 100, 1e9, {1000, 0.05}});
  EXPECT_NEAR(seconds(pieces), 1.15, 1e-9);
}

TEST(speed_plan, slows_down_before_the_slower_piece) {
  std::vector<PathPiece> pieces = {{100, 100, 1e9, {1000}}, {100, 50, 1e9, {1000}}};
  SpeedPlan().make(pieces, 0);
  EXPECT_DOUBLE_EQ(pieces[0].end, 50);
  EXPECT_NEAR(pieces[0].seconds, 0.1 + (100 - 5 - 3.75) / 100 + 0.05, 1e-12);  // 5 mm to accelerate; (100² − 50²)/2000 mm to brake
  EXPECT_NEAR(pieces[1].seconds, 0.05 + (100 - 1.25) / 50, 1e-12);
}

}  // namespace
}  // namespace kadr::speed_plan_test
