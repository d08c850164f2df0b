// path/curve/machine_path: the box of a piece of path holds every point of it and is no larger. The slow reference is the sampled path.

#include "path/curve/machine_path.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "random_motion.h"

namespace kadr::machine_path_test {
namespace {

using test::any_motion;
using test::Moved;
using test::straight;
using enum MotionKind;

TEST(machine_path, a_line_in_machine_coordinates) {
  const AxisRoles roles = AxisRoles::of({"X", "Y", "Z"}, 0);
  const ToolPosition from{{0, 0, 0}, {100, 0, 0}};
  Motion m = straight(feed, {10, 20, -30});
  m.machine = {110, 20, -30};
  const Curve curve(roles, from.work, m);
  const MachinePath path(roles, from, m, curve);
  EXPECT_TRUE(path.straight());
  EXPECT_EQ(path.at(0.5), (Axes{105, 10, -15}));
  EXPECT_EQ(path.extents(0.5, 1).least, (Axes{105, 10, -30}));
  EXPECT_EQ(path.extents(0.5, 1).most, (Axes{110, 20, -15}));
}

TEST(machine_path, an_axis_that_rolls_over_counts_on) {
  const AxisRoles roles = AxisRoles::of({"X", "C"}, 2);
  const ToolPosition from{{0, 350}, {0, 350}};
  Motion m = straight(rapid, {5, 30, 0});
  MotionDetail detail;
  detail.rolled = 2;
  detail.travel = {0, 40};
  m.detail = std::make_shared<MotionDetail>(detail);
  const Curve curve(roles, from.work, m);
  const MachinePath path(roles, from, m, curve);
  EXPECT_TRUE(path.rolls_over(1));
  EXPECT_FALSE(path.rolls_over(0));
  EXPECT_EQ(path.end(), (Axes{5, 390}));
  EXPECT_EQ(path.at(0.5), (Axes{2.5, 370}));
}

TEST(machine_path, a_quarter_of_a_circle_has_its_own_box) {
  const AxisRoles roles = AxisRoles::of({"X", "Y", "Z"}, 0);
  const ToolPosition from{{10, 0, 0}, {10, 0, 0}};
  const Motion m = test::arc(arc_ccw, {10, 0, 0}, {0, 0, 0}, 1);
  const Curve curve(roles, from.work, m);
  const MachinePath path(roles, from, m, curve);
  const Extents second = path.extents(0.25, 0.5);
  EXPECT_NEAR(second.least[0], -10, 1e-12);
  EXPECT_NEAR(second.most[0], 0, 1e-12);
  EXPECT_NEAR(second.least[1], 0, 1e-12);
  EXPECT_NEAR(second.most[1], 10, 1e-12);
}

RC_GTEST_PROP(machine_path, boxes_of_pieces_are_those_of_their_points, ()) {
  const Moved moved = any_motion();
  const Curve curve(moved.roles, moved.from.work, moved.motion);
  const MachinePath path(moved.roles, moved.from, moved.motion, curve);
  const double first = *rc::gen::inRange(0, 1000) / 1000.0, last = *rc::gen::inRange(0, 1001) / 1000.0;
  RC_PRE(first < last);
  const Extents box = path.extents(first, last);
  Extents seen{path.at(first), path.at(first)};
  constexpr int steps = 2000;
  for (int i = 0; i <= steps; ++i) {
    const Axes point = path.at(first + (last - first) * i / steps);
    for (std::size_t a = 0; a < moved.roles.count; ++a) {
      seen.least[a] = std::min(seen.least[a], point[a]);
      seen.most[a] = std::max(seen.most[a], point[a]);
      RC_ASSERT(point[a] >= box.least[a] - 1e-7 && point[a] <= box.most[a] + 1e-7);
    }
  }
  for (std::size_t a = 0; a < moved.roles.count; ++a) {  // samples miss an extreme by at most their distance
    const double slack = (box.most[a] - box.least[a]) * 0.02 + 1e-6;
    RC_ASSERT(seen.least[a] <= box.least[a] + slack && seen.most[a] >= box.most[a] - slack);
  }
}

RC_GTEST_PROP(machine_path, followers_copy_the_way_of_their_masters_and_nothing_else_changes, ()) {
  Moved moved = test::any_own_motion();
  const Motion alone = moved.motion;
  test::let_follow(moved);
  const Curve without(moved.roles, moved.from.work, alone), with(moved.roles, moved.from.work, moved.motion);
  RC_ASSERT(without.length() == with.length());
  const MachinePath path(moved.roles, moved.from, moved.motion, with), own(moved.roles, moved.from, alone, without);
  for (const double part : {0.0, 0.13, 0.5, 0.77, 1.0}) {
    const Axes at = path.at(part);
    for (std::size_t a = 0; a < 4; ++a) RC_ASSERT(at[a] == own.at(part)[a]);
    for (const Follower& f : moved.motion.detail->followers) {
      const double travel = at[f.axis] - moved.from.machine[f.axis];
      RC_ASSERT(std::fabs(travel - f.sign * (at[f.master] - moved.from.machine[f.master])) < 1e-9);
    }
  }
}

}  // namespace
}  // namespace kadr::machine_path_test
