// motion/pace: the time of a motion in polar interpolation, shared by its pieces. NCT 4.5.

#include "motion/pace.h"

#include <gtest/gtest.h>

#include "actions.h"

namespace kadr {
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
    detail.rotary_most = most;
    motion.to = {length(end), from[1] + FlatPath::line(start, end).swept(1)};
    motion.detail = std::make_shared<MotionDetail>(detail);
  }
};

TEST(pace, the_pieces_take_the_time_of_the_whole) {
  const PolarLine line({50, 1}, {-50, 1});
  const Curve curve(roles, line.from, line.motion);
  const Pace pace(roles, curve, line.motion, 1000, {10000, 10000});
  double sum = 0;
  constexpr int pieces = 1000;
  for (int i = 0; i < pieces; ++i) {
    const double from = double(i) / pieces, to = double(i + 1) / pieces, minutes = pace.minutes(from, to);
    EXPECT_LE(std::abs(curve.at(to)[1] - curve.at(from)[1]), most * minutes * (1 + 1e-12));
    sum += minutes;
  }
  EXPECT_NEAR(sum, minutes(curve, {1000, most}), 1e-3 * sum);
}

TEST(pace, rapid_as_the_slowest_axis) {
  const PolarLine line({50, 0}, {10, 0});
  const Curve curve(roles, line.from, line.motion);
  EXPECT_NEAR(Pace(roles, curve, line.motion, 0, {10000, 10000}).minutes(0, 1), 40.0 / 10000, 1e-15);
}

}  // namespace
}  // namespace kadr
