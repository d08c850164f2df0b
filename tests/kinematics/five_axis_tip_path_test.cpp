// kinematics/five_axis_tip_path: the tool axis moves in a plane or on a cone; the cutting point (NCT 25.16, 25.17).

#include "kinematics/five_axis_tip_path.h"

#include <gtest/gtest.h>

namespace kadr::five_axis_tip_path_test {
namespace {

std::shared_ptr<const FiveAxisTransform> c_b_head() {
  FiveAxisTransformData d;
  d.machine.group = MachineGroup::head_head;
  d.machine.first = {3, {0, 0, 1}, 1};
  d.machine.second = {4, {0, 1, 0}, 1};
  d.controls_tip = d.follows_head = true;
  return std::make_shared<const FiveAxisTransform>(d);
}

Vec3 direction(const std::shared_ptr<const FiveAxisTransform>& space, RotaryPair at) { return space->direction_of(at); }

TEST(direction_way, stays_in_the_plane_of_its_ends) {
  const auto space = c_b_head();
  const RotaryPair start{-135, 26};
  const Vec3 from = direction(space, start), to = direction(space, {-45, 35});
  const DirectionPath path(*space, start, from, to, std::nullopt);
  RotaryPair near = start;
  for (int i = 0; i <= 100; ++i) {
    const double part = i / 100.;
    const auto at = path.rotary(part, near);
    ASSERT_TRUE(at);
    EXPECT_NEAR(dot(cross(from, to), direction(space, *at)), 0, 1e-9);
    EXPECT_LT(std::hypot(at->first - near.first, at->second - near.second), 5);  // the solution stays on one branch: no jump
    near = *at;
  }
  EXPECT_NEAR(length(direction(space, near) - to), 0, 1e-9);
}

/// Through the pole the tilting axis continues to the other side, and the free axis does not move.
TEST(direction_way, goes_through_a_pole_without_whirling) {
  const auto space = c_b_head();
  const RotaryPair start{30, 20};
  const Vec3 from = direction(space, start), to = direction(space, {30, -20});
  const DirectionPath path(*space, start, from, to, std::nullopt);
  for (const double part : {0.1, 0.4, 0.49, 0.51, 0.6, 1.0}) {
    const auto at = path.rotary(part, start);
    ASSERT_TRUE(at);
    EXPECT_NEAR(at->first, 30, 1e-6);
    EXPECT_NEAR(at->second, 20 - 40 * part, 1e-6);
  }
}

TEST(direction_way, on_a_cone_turns_with_the_arc) {
  const auto space = c_b_head();
  const RotaryPair start{180, 20};
  const DirectionPath::Cone cone{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 90};
  const DirectionPath path(*space, start, direction(space, start), direction(space, {270, 20}), cone);
  for (const double part : {0.25, 0.5, 1.0}) {
    const auto at = path.rotary(part, start);
    ASSERT_TRUE(at);
    EXPECT_NEAR(at->first, 180 + 90 * part, 1e-6);
    EXPECT_NEAR(at->second, 20, 1e-6);
  }
}

/// The centre of a ball end is its radius away from the surface; a square end touches with its edge (25.17).
TEST(contact, the_tip_of_each_tool) {
  const Vec3 t{0, 0, 1}, n = unit({1, 0, 1});
  EXPECT_NEAR(length(contact_to_tip(n, t, 5, 5) + 5.0 * t - 5.0 * n), 0, 1e-12);
  EXPECT_NEAR(length(contact_to_tip(n, t, 5, 0) - Vec3{5, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(length(contact_to_tip(t, t, 5, 1)), 0, 1e-12);  // flat on the floor
}

}  // namespace
}  // namespace kadr::five_axis_tip_path_test
