// stock/bodies/body_world: distances compared with geometry, for every type of body.

#include "stock/bodies/body_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stock/some_tools.h"

namespace kadr::body_world_test {
namespace {

constexpr double exact = 5e-6;  // mm

class body_world : public testing::Test {
 protected:
  void SetUp() override { ASSERT_NE(bodies_library(), nullptr) << "kadr-bodies.so is not beside the tests"; }
};

BodyShape box(Vec3 least, Vec3 most) { return {BodyShape::Form::box, least, most, {}, 0, 0, 0, {}}; }
BodyShape cylinder(Vec2 centre, double bottom, double top, double diameter) {
  return {BodyShape::Form::cylinder, {}, {}, centre, bottom, top, diameter, {}};
}

/// Returns the gap between two intervals of a line.
double apart(double a0, double a1, double b0, double b1) { return std::max({b0 - a1, a0 - b1, 0.0}); }

TEST_F(body_world, boxes) {
  BodyWorld world(*bodies_library());
  const auto a = world.add(box({0, 0, 0}, {100, 80, 60})), b = world.add(box({-5, -10, -20}, {5, 10, 20}));
  ASSERT_TRUE(a && b);
  Chance chance(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 at{chance.between(-100, 200), chance.between(-100, 200), chance.between(-100, 200)};
    const double x = apart(0, 100, at.x - 5, at.x + 5), y = apart(0, 80, at.y - 10, at.y + 10), z = apart(0, 60, at.z - 20, at.z + 20);
    const double want = std::hypot(x, y, z);
    const BodyGap gap = world.gap(*a, {}, *b, {{}, at});
    if (want > 0) {
      EXPECT_NEAR(gap.distance, want, exact);
      EXPECT_NEAR(length(gap.on_first - gap.on_second), want, exact);
    } else {
      EXPECT_LE(gap.distance, 0);
    }
  }
  EXPECT_NEAR(world.depth(*a, {}, *b, {{}, {50, 40, 79.5}}), 0.5, 1e-4);
}

// Sides in a common plane, and edges that lie on each other: GJK is weak there, and machines are built that way.
TEST_F(body_world, boxes_that_are_flush) {
  BodyWorld world(*bodies_library());
  Chance chance(6);
  for (int i = 0; i < 20'000; ++i) {
    const auto side = [&] { return 20. * (1 + chance.below(10)); };
    const Vec3 a{side(), side(), side()}, b{side(), side(), side()},
        at{10. * (chance.below(61) - 30), 10. * (chance.below(61) - 30), 10. * (chance.below(61) - 30)};
    if (i % 500 == 0) world = BodyWorld(*bodies_library());
    const auto first = world.add(box(-0.5 * a, 0.5 * a)), second = world.add(box(-0.5 * b, 0.5 * b));
    const double x = std::fabs(at.x) - (a.x + b.x) / 2, y = std::fabs(at.y) - (a.y + b.y) / 2, z = std::fabs(at.z) - (a.z + b.z) / 2;
    const double want = std::hypot(std::max(x, 0.0), std::max(y, 0.0), std::max(z, 0.0)),
                 got = world.gap(*first, {}, *second, {{}, at}).distance;
    if (want > 0) {
      EXPECT_NEAR(got, want, exact);
    } else {
      EXPECT_LT(got, exact) << std::max({x, y, z});
    }
  }
}

TEST_F(body_world, a_cylinder_and_a_box) {
  BodyWorld world(*bodies_library());
  const auto a = world.add(box({-200, -150, -100}, {200, 150, 100})), b = world.add(cylinder({10, 20}, 5, 125, 70));
  ASSERT_TRUE(a && b);
  Chance chance(2);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 at{chance.between(-400, 400), chance.between(-400, 400), chance.between(-300, 300)};
    const double side = std::hypot(std::max(std::fabs(at.x + 10) - 200, 0.0), std::max(std::fabs(at.y + 20) - 150, 0.0));
    const double want = std::hypot(std::max(side - 35, 0.0), apart(-100, 100, at.z + 5, at.z + 125));
    const double got = world.gap(*a, {}, *b, {{}, at}).distance;
    if (want > exact) {
      EXPECT_NEAR(got, want, exact);
    } else {
      EXPECT_LT(got, exact);
    }
  }
}

// A mesh compared with the box that it represents.
TEST_F(body_world, a_mesh_is_what_it_shows) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    for (const int d : {0, 1, 2}) mesh.points.push_back((i >> d & 1) != 0 ? 50.0F : -50.0F);
  mesh.triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  BodyWorld world(*bodies_library());
  const auto whole = world.add(mesh), as_box = world.add(box({-50, -50, -50}, {50, 50, 50})), tool = world.add(cylinder({0, 0}, 0, 80, 20));
  ASSERT_TRUE(whole && as_box && tool);
  EXPECT_FALSE(whole->convex);
  Chance chance(3);
  for (int i = 0; i < 500; ++i) {
    const LinkPose pose{Mat3::about(unit({chance.between(-1, 1), chance.between(-1, 1), 1}), chance.between(-180, 180)),
                        {chance.between(-200, 200), chance.between(-200, 200), chance.between(60, 200)}};
    const double want = world.gap(*as_box, {}, *tool, pose).distance, got = world.gap(*whole, {}, *tool, pose).distance;
    if (want > 0) {
      EXPECT_NEAR(got, want, 1e-5);
    }
  }
}

// The parts of every type of tool against a plane: their widest part seen from below, their lowest point, their rim seen from the side.
TEST_F(body_world, tools_are_as_wide_and_as_high_as_they_are) {
  Chance chance(4);
  BodyWorld world(*bodies_library());
  const auto plane = world.add(box({-1000, -1000, -10}, {1000, 1000, 0}));
  for (int i = 0; i < 60; ++i) {
    const ToolShape tool = some_tool(chance, SomeTool(i % some_tools));
    for (const ConvexBody& body : tool.bodies) {
      const auto solid = world.add(body);
      ASSERT_TRUE(solid && plane);
      EXPECT_NEAR(world.gap(*solid, {{}, {0, 0, 100}}, *plane, {}).distance, 100 + body.bottom(), 1e-5);
      const LinkPose lying{Mat3::about({0, 1, 0}, 90), {0, 0, 300}};
      const double side = world.gap(*solid, lying, *plane, {}).distance;
      EXPECT_LE(side, 300 - body.widest() + 1e-5);
      EXPECT_GE(side, 300 - body.widest() * 1.0004 - 0.003);
      EXPECT_GE(solid->ball.radius + 1e-9, 0.5 * (body.top() - body.bottom()));
    }
  }
}

}  // namespace
}  // namespace kadr::body_world_test
