// Turned parts compared as regions of the half plane.

#include "stock/turned/turned_part.h"

#include <gtest/gtest.h>

#include <numbers>

#include "stock/turned/turned_mesh.h"

namespace kadr::turned_part_test {
namespace {

constexpr double pi = std::numbers::pi;

/// A shaft with a shoulder, a cone and a blind bore.
TurnedRegion shaft() { return {{{0, -40}, {20, -40}, {20, -20}, {15, -10}, {15, 0}, {5, 0}, {5, -12}, {0, -14}}}; }

TEST(TurnedPart, TheSectionOfAMeshIsTheRegion) {
  const auto section = section_of(turned_mesh(shaft(), 0.01), 0.01);
  ASSERT_TRUE(section);
  EXPECT_NEAR(volume_of(*section), volume_of(shaft()), 1e-3 * volume_of(shaft()) * 1e-2);
  const TurnedComparison same = compare(*section, shaft());
  EXPECT_EQ(same.left_on.volume, 0);
  EXPECT_EQ(same.gouged.volume, 0);
}

TEST(TurnedPart, ATubeHasNoEdgeOnTheAxis) {
  const TurnedRegion tube = cylinder_region(-10, 5, 40, 20);
  const auto section = section_of(turned_mesh(tube, 0.01), 0.01);
  ASSERT_TRUE(section);
  EXPECT_NEAR(volume_of(*section), volume_of(tube), 0.01);
}

TEST(TurnedPart, AHollowBodyKeepsItsCavity) {
  TurnedRegion hollow = cylinder_region(-10, 10, 40);
  hollow.push_back({{10, -5}, {10, 5}, {15, 5}, {15, -5}});
  const auto section = section_of(turned_mesh(hollow, 0.01), 0.01);
  ASSERT_TRUE(section);
  EXPECT_NEAR(volume_of(*section), pi * (400 * 20 - (225 - 100) * 10), 0.1);
}

TEST(TurnedPart, ABoxIsNoBodyOfRevolution) {
  Mesh box;
  for (int i = 0; i < 8; ++i)
    for (const int v : {i & 1 ? 10 : -10, i & 2 ? 10 : -10, i & 4 ? 10 : -10}) box.points.push_back(float(v));
  box.triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  EXPECT_FALSE(section_of(box, 0.05));
}

TEST(TurnedPart, DepthAndVolumeOfADifference) {
  const TurnedRegion wanted = cylinder_region(-30, 0, 30);
  TurnedRegion part = {{{0, -30}, {15, -30}, {15, -20}, {14.5, -20}, {14.5, -15}, {15, -15}, {15, 0}, {0, 0}}};  // a groove, 0.5 deep
  TurnedComparison c = compare(part, wanted);
  EXPECT_NEAR(c.gouged.volume, pi * (15 * 15 - 14.5 * 14.5) * 5, 1e-3);
  EXPECT_NEAR(c.gouged.deepest, 0.5, 1e-6);
  EXPECT_NEAR(c.gouged.at.x, 14.5, 1e-6);
  EXPECT_EQ(c.left_on.volume, 0);
  c = compare(wanted, part);
  EXPECT_NEAR(c.left_on.deepest, 0.5, 1e-6);
  EXPECT_EQ(c.gouged.volume, 0);
}

TEST(TurnedPart, RoundingDoesNotCount) {
  EXPECT_EQ(compare(cylinder_region(-30, 0, 30.003), cylinder_region(-30, 0, 30)).left_on.volume, 0);
  EXPECT_GT(compare(cylinder_region(-30, 0, 30.006), cylinder_region(-30, 0, 30)).left_on.volume, 0);
}

TEST(TurnedPart, SignedDistance) {
  const TurnedRegion wanted = cylinder_region(-30, 0, 30);
  EXPECT_NEAR(distance_from(wanted, {16, -10}), 1, 1e-9);
  EXPECT_NEAR(distance_from(wanted, {14, -10}), -1, 1e-9);
  EXPECT_NEAR(distance_from(wanted, {0, -10}), -10, 1e-9);  // the axis is no surface
}

}  // namespace
}  // namespace kadr::turned_part_test
