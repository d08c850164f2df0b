// The rounded path: its distance from the straight segments.

#include "path/smooth/smooth_path.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace kadr::smooth_path_test {
namespace {

struct Corner {
  double x, y, tolerance;
};

/// Returns the greatest displacement of any point, as a share of the largest tolerance among the corners that affect the point.
double most_moved(const std::vector<Corner>& corners) {
  SmoothPath path(2);
  const double start[2] = {0, 0};
  path.begin(start);
  for (const Corner& corner : corners) path.line_to(&corner.x, 100, corner.tolerance, false, 0);
  path.settle(true);
  double worst = 0;
  std::size_t piece = 0;
  for (double s = 0; s < path.ends(); s += 0.002) {
    piece = path.piece_at(s, piece);
    double at[2], slope[2], bend[2], tolerance = 0;
    path.evaluate(s, piece, at, slope, bend);
    const Corner from = piece > 0 ? corners[piece - 1] : Corner{0, 0, 0}, to = corners[piece];
    const double part = (s - path.at(piece)) / (path.at(piece + 1) - path.at(piece));
    const double moved = std::hypot(from.x + part * (to.x - from.x) - at[0], from.y + part * (to.y - from.y) - at[1]);
    for (std::size_t i = 1; i < corners.size(); ++i)
      if (std::fabs(path.at(i) - s) < path.felt(i, s, piece)) tolerance = std::max(tolerance, corners[i].tolerance);
    worst = std::max(worst, moved > 1e-9 ? moved / tolerance : 0);
  }
  return worst;
}

TEST(SmoothPath, ACornerAloneUsesItsTolerance) { EXPECT_NEAR(most_moved({{30, 0, 0.02}, {30, 30, 0.02}}), 1, 1e-3); }

// A gentle corner close to a sharp one: the path is displaced most after both.
TEST(SmoothPath, AWideRoundingBesideANarrowOneStaysWithin) {
  EXPECT_LE(most_moved({{3, 0, 0.005}, {3.004, 0.0097, 0.005}, {3.3, 1.32, 0.005}, {5, 1.2, 0.005}, {5, 4, 0.005}}), 1.001);
}

/// Returns how much position, direction and curvature at the vertex `i` differ from those just before and after it.
double jump_at(SmoothPath& path, std::size_t i) {
  constexpr double aside = 1e-9;  // mm
  double jump = 0;
  for (const int side : {-1, 1}) {
    double x[2], x1[2], x2[2], y[2], y1[2], y2[2];
    const double s = path.at(i), near = s + side * aside;
    path.evaluate(s, path.piece_at(s, 0), x, x1, x2);
    path.evaluate(near, path.piece_at(near, 0), y, y1, y2);
    for (int a = 0; a < 2; ++a) jump = std::max({jump, std::fabs(x[a] - y[a]), std::fabs(x1[a] - y1[a]), 0.01 * std::fabs(x2[a] - y2[a])});
  }
  return jump;
}

// Regression: a cell may begin exactly at a corner; its direction contained half a corner too much.
TEST(SmoothPath, IsSmoothAtTheCornersThemselves) {
  SmoothPath path(2);
  const double start[2] = {0, 0};
  path.begin(start);
  for (int i = 1; i <= 40; ++i) {  // gentle corners that are rounded together, then sharp corners
    const double to[2] = {0.25 * i, std::sin(0.25 * i)};
    path.line_to(to, 100, 0.01, false, 0);
  }
  for (const auto& to : {std::array<double, 2>{12, 3}, {14, -3}, {20, 0}}) path.line_to(to.data(), 100, 0.01, false, 0);
  path.settle(true);
  EXPECT_TRUE(path.is_chained(20));
  EXPECT_FALSE(path.is_chained(42));
  for (std::size_t i = 1; i < path.pieces(); ++i) EXPECT_LE(jump_at(path, i), 1e-5) << i;
}

// The room at a reversal reaches to the next position where the axes stop for an instant, on either side.
TEST(SmoothPath, TheRoomOfWhereItTurnsBack) {
  SmoothPath path(1);
  const double start = 0;
  path.begin(&start);
  for (const double to : {1.0, 0.75, 0.875, 0.874}) path.line_to(&to, 1, 0.01, false, 0);
  path.settle(true);
  const double expected[] = {1, 0.25, 0.125, 0.001, 0.001};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(path.room(i), expected[i], 1e-12) << i;
}

// A right angle. Its corner is cut by at most the tolerance t, so a point
// on the bisector at 2 t from the corner is beyond the tolerance by t.
TEST(SmoothPath, HowFarAPointIsBeyondTheTolerance) {
  constexpr double tolerance = 0.02;
  SmoothPath path(2);
  for (const std::array<double, 2>& to : {std::array{0.0, 0.0}, std::array{10.0, 0.0}, std::array{10.0, 10.0}})
    to[0] + to[1] == 0 ? path.begin(to.data()) : path.line_to(to.data(), 1, tolerance, false, 0);
  path.settle(true);
  const auto beyond = [&](double x, double y) {
    const std::array<double, 2> at{x, y};
    return path.beyond(10, 1, at.data());
  };
  EXPECT_EQ(beyond(10, 0), 0);
  EXPECT_EQ(beyond(10 - 0.99 * tolerance, 0.99 * tolerance), 0);
  EXPECT_NEAR(beyond(10 - 2 * tolerance, 2 * tolerance), 1, 1e-9);
  EXPECT_NEAR(beyond(10 + 1.5 * tolerance, 0), 0.5, 1e-9);
}

RC_GTEST_PROP(SmoothPathProperty, StaysWithinTheTolerance, ()) {
  const int kind = *rc::gen::inRange(0, 3), count = *rc::gen::inRange(2, 40);
  const bool mixed = *rc::gen::arbitrary<bool>();
  const double one = *rc::gen::element(0.005, 0.02, 0.1);
  std::vector<Corner> corners;
  double x = 0, y = 0, heading = 0;
  for (int i = 0; i < count; ++i) {
    const double step = *rc::gen::inRange(10, kind == 0 ? 500 : kind == 1 ? 20000 : 3000) * 1e-3;
    heading += kind == 0 ? *rc::gen::inRange(-100, 101) * 2e-3 : *rc::gen::inRange(0, 361) * 3.14159265358979323846 / 180;
    x += step * std::cos(heading), y += step * std::sin(heading);
    corners.push_back({x, y, mixed ? *rc::gen::element(0.005, 0.02, 0.1) : one});
  }
  RC_ASSERT(most_moved(corners) <= 1.01);  // sampled at some positions only: docs/planner.md
}

}  // namespace
}  // namespace kadr::smooth_path_test
