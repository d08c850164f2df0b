// The surface of a turned part for its picture.

#include "stock/turned/turned_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace kadr::turned_picture_test {
namespace {

constexpr double pi = std::numbers::pi;

TEST(TurnedPicture, AShaftIsWhole) {
  const Surface surface = turned_picture(cylinder_region(-30, 0, 20), {}, {}, 0.005);
  EXPECT_NEAR(volume_of(surface), pi * 100 * 30, 2);
  const Box3 box = box_of(surface);
  EXPECT_NEAR(box.least.x, -30, 1e-5);  // Z points to the right
  EXPECT_NEAR(box.most.x, 0, 1e-5);
  for (const std::int32_t by : surface.made_by) EXPECT_EQ(by, of_blank);
}

TEST(TurnedPicture, ABoreIsSeenInSection) {
  const Surface surface = turned_picture(cylinder_region(-30, 0, 20, 10), {}, {}, 0.005);
  EXPECT_NEAR(volume_of(surface), 0.75 * pi * (100 - 25) * 30, 2);  // closed by the section, whose triangles face outwards
}

TEST(TurnedPicture, EachEdgeHasTheToolThatCutItLast) {
  const TurnedRegion blank = cylinder_region(-30, 0, 40), turned = {{{0, -30}, {20, -30}, {20, -20}, {15, -20}, {15, 0}, {0, 0}}};
  const TurnedRegion grooved = {{{0, -30}, {20, -30}, {20, -20}, {15, -20}, {15, -12}, {13, -12}, {13, -10}, {15, -10}, {15, 0}, {0, 0}}};
  const Surface surface = turned_picture(grooved, {{0, blank}, {1, turned}}, {}, 0.005);
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

/// Returns an M16x2 groove of 10 mm with a triangular insert, cut to a depth below a radius.
ThreadGroove groove_of(double radius, double depth, bool is_outer) {
  const double side = is_outer ? 1 : -1, half = 2 * std::tan(pi / 6);
  ThreadGroove groove;
  groove.outline = is_outer ? TurnedPolygon{{0, 0}, {2, -half}, {2, half}} : TurnedPolygon{{0, 0}, {-2, half}, {-2, -half}};
  groove.from = {radius - side * depth, -6}, groove.to = {radius - side * depth, -16};
  groove.start = -6, groove.lead = 2, groove.is_outer = is_outer, groove.maker = 3;
  return groove;
}

/// Returns how much a thread of the full depth removes along a length, mm³, by Pappus: per turn a triangle whose centroid is at two thirds
/// of the depth.
double removed_by_thread(double radius, double depth, double length, bool is_outer) {
  const double area = depth * depth * std::tan(pi / 6), centroid = radius + (is_outer ? -1 : 1) * depth / 3;
  return 2 * pi * centroid * area * length / 2;
}

TEST(TurnedPicture, AThreadIsAHelicalGroove) {
  const ThreadGroove groove = groove_of(8, 1, true);
  const TurnedRegion rod = cylinder_region(-30, 0, 16);
  const Surface plain = turned_picture(rod, {}, {}, 0.005), threaded = turned_picture(rod, {}, {groove}, 0.005);
  const double removed = volume_of(plain) - volume_of(threaded), expected = removed_by_thread(8, 1, 10, true);
  EXPECT_NEAR(removed, expected, 0.05 * expected);  // the groove ends within its width
  EXPECT_GT(std::count(threaded.made_by.begin(), threaded.made_by.end(), 3), 1000);
}

TEST(TurnedPicture, AThreadInABoreIsSeenInSection) {
  const ThreadGroove groove = groove_of(8, 1, false);
  const TurnedRegion ring = cylinder_region(-30, 0, 40, 16);
  const double removed = volume_of(turned_picture(ring, {}, {}, 0.005)) - volume_of(turned_picture(ring, {}, {groove}, 0.005));
  const double expected = 0.75 * removed_by_thread(8, 1, 10, false);
  EXPECT_NEAR(removed, expected, 0.05 * expected);
}

}  // namespace
}  // namespace kadr::turned_picture_test
