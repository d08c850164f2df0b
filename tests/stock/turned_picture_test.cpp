// The surface of a turned part for its picture.

#include "stock/turned/turned_picture.h"

#include <gtest/gtest.h>

#include <numbers>

namespace kadr::turned_picture_test {
namespace {

constexpr double pi = std::numbers::pi;

TEST(TurnedPicture, AShaftIsWhole) {
  const Surface surface = turned_picture(cylinder_region(-30, 0, 20), {}, 0.005);
  EXPECT_NEAR(volume_of(surface), pi * 100 * 30, 2);
  const Box3 box = box_of(surface);
  EXPECT_NEAR(box.least.x, -30, 1e-5);  // Z points to the right
  EXPECT_NEAR(box.most.x, 0, 1e-5);
  for (const std::int32_t by : surface.made_by) EXPECT_EQ(by, of_blank);
}

TEST(TurnedPicture, ABoreIsSeenInSection) {
  const Surface surface = turned_picture(cylinder_region(-30, 0, 20, 10), {}, 0.005);
  EXPECT_NEAR(volume_of(surface), 0.75 * pi * (100 - 25) * 30, 2);  // closed by the section, whose triangles face outwards
}

TEST(TurnedPicture, EachEdgeHasTheToolThatCutItLast) {
  const TurnedRegion blank = cylinder_region(-30, 0, 40), turned = {{{0, -30}, {20, -30}, {20, -20}, {15, -20}, {15, 0}, {0, 0}}};
  const TurnedRegion grooved = {{{0, -30}, {20, -30}, {20, -20}, {15, -20}, {15, -12}, {13, -12}, {13, -10}, {15, -10}, {15, 0}, {0, 0}}};
  const Surface surface = turned_picture(grooved, {{0, blank}, {1, turned}}, 0.005);
  for (std::size_t i = 0; i < surface.made_by.size(); ++i) {
    const Vec3 p = surface.point(i);
    const double r = std::hypot(p.y, p.z);
    if (r > 13.1 && r < 14.9) {
      EXPECT_EQ(surface.made_by[i], 1);
    }
    if (r > 19.9 || p.x < -29.9) {
      EXPECT_NE(surface.made_by[i], 1);
    }
  }
  std::size_t of_tool[3] = {};
  for (const std::int32_t by : surface.made_by) ++of_tool[by + 1];
  EXPECT_GT(of_tool[0], 0U);
  EXPECT_GT(of_tool[1], 0U);
  EXPECT_GT(of_tool[2], 0U);
}

}  // namespace
}  // namespace kadr::turned_picture_test
