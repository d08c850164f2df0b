// session/cutting/turned_path: converts positions in space to radius and height.

#include "session/cutting/turned_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace kadr::turned_way_test {
namespace {

struct Part {
  Vec3 from, to;
};

std::vector<Part> parts_of(Vec3 from, Vec3 to, Vec3 zero = {}) {
  const std::vector<PathSegment> pieces{{from, to, 0, 1}};
  std::vector<Part> parts;
  each_turned(pieces.front(), zero, radius_axis(pieces, zero), 1e-4, [&](Vec3 a, Vec3 b) { parts.push_back({a, b}); });
  return parts;
}

TEST(TurnedPath, KeepsItsSignInThePlane) {
  const auto in_x = parts_of({110, 50, 3}, {95, 50, 7}, {100, 50, 1});
  ASSERT_EQ(in_x.size(), 1u);
  EXPECT_EQ(in_x[0].from, (Vec3{10, 0, 2}));
  EXPECT_EQ(in_x[0].to, (Vec3{-5, 0, 6}));
  const auto in_y = parts_of({0, -40, 50}, {0, 2, 0});
  ASSERT_EQ(in_y.size(), 1u);
  EXPECT_EQ(in_y[0].from, (Vec3{-40, 0, 50}));
  EXPECT_EQ(in_y[0].to, (Vec3{2, 0, 0}));
}

TEST(TurnedPath, BesideThePlaneTheDistanceFromTheAxisCounts) {
  const Vec3 from{-20, 3, 0}, to{15, 3, 10};
  const auto parts = parts_of(from, to);
  ASSERT_GT(parts.size(), 10u);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double share = (double(i) + 0.5) / double(parts.size());
    const Vec3 at = from + share * (to - from);
    EXPECT_NEAR(0.5 * (parts[i].from.x + parts[i].to.x), -std::hypot(at.x, at.y), 1.01e-4);
    if (i != 0) {
      EXPECT_EQ(parts[i].from, parts[i - 1].to);
    }
  }
  EXPECT_NEAR(parts.back().to.x, -std::hypot(15, 3), 1e-12);
}

}  // namespace
}  // namespace kadr::turned_way_test
