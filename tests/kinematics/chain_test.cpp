// kinematics/chain: from axis positions to the tool and back.

#include "kinematics/chain.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace kadr::chain_test {
namespace {

TEST(three_axes, carry_the_tip_to_X_Y_Z_whatever_the_others_do) {
  const Chain chain(AxisRoles::of({"X", "Y", "Z", "A", "C"}, 0b11000));
  const Pose pose = chain.forward({1, 2, 3, 40, 50});
  EXPECT_EQ(pose.tip, (Vec3{1, 2, 3}));
  EXPECT_EQ(pose.direction, (Vec3{0, 0, 1}));
}

TEST(three_axes, are_found_by_their_letters) {
  EXPECT_EQ(Chain(AxisRoles::of({"Z", "C", "X"}, 0b10)).tip({7, 90, 5}), (Vec3{5, 0, 7}));
  EXPECT_EQ(Chain(AxisRoles::of({"U", "V"}, 0)).tip({7, 9}), (Vec3{}));
}

TEST(three_axes, cannot_tilt_the_tool) {
  const Chain chain(AxisRoles::of({"X", "Y", "Z"}, 0));
  EXPECT_FALSE(chain.inverse({{}, {0, 0.6, 0.8}}, {}));
  EXPECT_FALSE(chain.inverse({{}, {0, 0, -1}}, {}));
  EXPECT_FALSE(chain.inverse({{}, {0, 0, std::nan("")}}, {}));
  EXPECT_TRUE(chain.inverse({{}, {0, 0, 1}}, {}));
}

TEST(three_axes, cannot_move_along_an_axis_that_is_missing) {
  const Chain lathe(AxisRoles::of({"X", "Z"}, 0));
  EXPECT_FALSE(lathe.inverse({{1, 2, 3}}, {}));
  EXPECT_EQ(lathe.inverse({{1, 0, 3}}, {})->at(1), 3);
}

RC_GTEST_PROP(three_axes, forward_of_inverse_is_the_same, ()) {
  const std::vector<std::string> names =
      *rc::gen::element(std::vector<std::string>{"X", "Y", "Z", "C"}, std::vector<std::string>{"C", "Z", "Y", "X", "W"});
  const Chain chain(AxisRoles::of(names, 0));
  const auto number = [] { return *rc::gen::inRange(-1'000'000, 1'000'000) / 997.0; };
  Axes near{};
  for (double& axis : near) axis = number();
  const Pose pose{{number(), number(), number()}};
  const auto axes = chain.inverse(pose, near);
  RC_ASSERT(axes.has_value());
  RC_ASSERT(chain.forward(*axes).tip == pose.tip);
  for (std::size_t a = 0; a < names.size(); ++a)
    if (names[a] == "C" || names[a] == "W") RC_ASSERT((*axes)[a] == near[a]);
}

}  // namespace
}  // namespace kadr::chain_test
