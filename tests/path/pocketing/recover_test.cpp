// Recovery of exact edges: short chords in any direction at the ends of an arc do not spoil it.

#include <gtest/gtest.h>

#include <cmath>

#include "base/tolerance.h"
#include "path/pocketing/exact_path.h"

namespace kadr::area::recover_test {
namespace {

/// Returns points on the circle of radius 5 around the origin, from one angle to the other, one per degree.
Polygon corners_on_circle(int from_deg, int to_deg) {
  Polygon corners;
  for (int deg = from_deg; deg != to_deg; deg += deg < to_deg ? 1 : -1) corners.push_back(rotated(Vec2{5, 0}, deg));
  corners.push_back(rotated(Vec2{5, 0}, to_deg));
  return corners;
}

Carriers on_circle() {
  Carriers carriers;
  carriers.add({{{-5, 0}, {5, 0}, 1}, {{5, 0}, {-5, 0}, 1}}, 0);
  return carriers;
}

double swept_deg(const Edges& path) {
  double sum = 0;
  for (const Edge& e : path) sum += 4 * std::atan(e.bulge) / rad_per_deg;
  return sum;
}

TEST(Recover, ArcsBothWays) {
  const Carriers carriers = on_circle();
  for (const int end : {40, -40, 200, -200, 300, -300, 359, -359, 360, -360})
    EXPECT_NEAR(swept_deg(carriers.recovered(corners_on_circle(0, end), false)), end, 1e-6) << end;
}

TEST(Recover, AFirstChordThatGoesBack) {
  // A remainder of a neighbouring line where a rim was clipped: half a micrometre long, against the direction of the arc.
  const Carriers carriers = on_circle();
  for (const int end : {40, -40}) {
    Polygon corners = corners_on_circle(0, end);
    corners.insert(corners.begin(), corners[0] + Vec2{2e-4, end > 0 ? 4e-4 : -4e-4});
    const Edges path = carriers.recovered(corners, false);
    ASSERT_EQ(path.size(), 1U);
    EXPECT_NEAR(swept_deg(path), end, 0.01);
    EXPECT_NEAR(distance(path[0], rotated(Vec2{5, 0}, end / 2)), 0, 3 * tol::area_chord);
  }
}

TEST(Recover, AWholeCircle) {
  const Carriers carriers = on_circle();
  for (const int end : {360, -360}) {
    Polygon corners = corners_on_circle(0, end);
    corners.pop_back();
    const Edges path = carriers.recovered(corners, true);
    ASSERT_EQ(path.size(), 2U);
    EXPECT_NEAR(swept_deg(path), end, 1e-6);
    EXPECT_LT(length(path[1].to - path[0].from), tol::same_point);
  }
}

}  // namespace
}  // namespace kadr::area::recover_test
