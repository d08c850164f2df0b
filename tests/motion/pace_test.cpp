// motion/time/pace: shares the time of a motion in polar interpolation among its segments. NCT 4.5.

#include "motion/time/pace.h"

#include <gtest/gtest.h>

#include "actions.h"

namespace kadr::pace_test {
namespace {

constexpr double most = 3600;  // degrees/min
const AxisRoles roles = AxisRoles::of({"X", "C"}, 2);

struct PolarLine {
  Axes from;
  Motion motion;

  PolarLine(Vec2 start, Vec2 end) : from{length(start), angle_deg(start)}, motion(test::straight(MotionKind::feed, {}, 1000)) {
    MotionDetail detail;
    detail.surface = PathSurface::polar;
    detail.flat_from = start;
    detail.flat_to = end;
    detail.max_rotary_speed = most;
    motion.to = {length(end), from[1] + FlatPath::line(start, end).swept(1)};
    motion.detail = std::make_shared<MotionDetail>(detail);
  }
};

TEST(pace, the_pieces_take_the_time_of_the_whole) {
  const PolarLine line({50, 1}, {-50, 1});
  const Curve curve(roles, line.from, line.motion);
  const SpindleTurning spindle;
  const Pace pace(roles, curve, line.motion, 1000, {10000, 10000}, spindle);
  double sum = 0;
  constexpr int pieces = 1000;
  for (int i = 0; i < pieces; ++i) {
    const double from = double(i) / pieces, to = double(i + 1) / pieces, minutes = pace.minutes(from, to);
    EXPECT_LE(std::abs(curve.at(to)[1] - curve.at(from)[1]), most * minutes * (1 + 1e-12));
    sum += minutes;
  }
  EXPECT_NEAR(sum, minutes(curve, {1000, most}), 1e-3 * sum);
}

// 11.5: from x = 100 to 20 at 200 m/min the spindle becomes five times as fast; at x below 31.8 mm it stays at 1000 rev/min.
TEST(pace, a_feed_a_turn_goes_with_a_spindle_of_constant_surface_speed) {
  Motion motion = test::straight(MotionKind::feed, {20, 0}, 0.2);
  motion.unit = FeedUnit::mm_per_rev;
  const AxisRoles axes = AxisRoles::of({"X", "Z"}, 2);
  const Axes from{100, 0};
  const Curve curve(axes, from, motion);
  SpindleTurning spindle;
  spindle.surface = {true, 1, 0, 200, 0, 1000};
  const Pace pace(axes, curve, motion, 63.66, {10000, 10000}, spindle);
  EXPECT_FALSE(pace.is_even());
  const int pieces = pace.pieces();
  EXPECT_GE(pieces, 80 / (0.02 * 31.8));
  EXPECT_NEAR(pace.minutes(0, 0.1) / pace.minutes(0.5, 0.6), 96.0 / 56, 1e-12);
  EXPECT_NEAR(pace.minutes(0.9, 0.95), pace.minutes(0.95, 1), 1e-12);
  motion.unit = FeedUnit::mm_per_min;
  EXPECT_TRUE(Pace(axes, curve, motion, 100, {10000, 10000}, spindle).is_even());
}

TEST(pace, rapid_as_the_slowest_axis) {
  const PolarLine line({50, 0}, {10, 0});
  const Curve curve(roles, line.from, line.motion);
  EXPECT_NEAR(Pace(roles, curve, line.motion, 0, {10000, 10000}, SpindleTurning{}).minutes(0, 1), 40.0 / 10000, 1e-15);
}

}  // namespace
}  // namespace kadr::pace_test
