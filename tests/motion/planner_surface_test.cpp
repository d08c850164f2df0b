// Surfaces of thousands of short lines, as load/gen_load.py writes them. Every sample is checked by a search for the nearest point that
// does not use how the path was rounded.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "looked_cells.h"
#include "motion/least_time/planner.h"
#include "planned_run.h"

namespace kadr::planner_surface_test {
namespace {

using test::Point;

constexpr double tolerance = 0.01;

struct Surface {
  const char* name;
  double step;      // mm
  double decimals;  // decimals of the words
  double feed;      // mm/s
  int lines = 12000;
};

std::vector<Point> points_of(const Surface& surface) {
  constexpr int in_row = 1000;
  std::vector<Point> points;
  const auto rounded = [&](double x) { return std::round(x * surface.decimals) / surface.decimals; };
  for (int i = 0; i < surface.lines; ++i) {
    const int row = i / in_row, column = row % 2 == 0 ? i % in_row : in_row - 1 - i % in_row;
    const double x = column * surface.step, y = row * 0.1;
    points.push_back({rounded(x), rounded(y), rounded(-8 + 2 * std::sin(x / 3) * std::cos(y) + 0.7 * std::cos(x * 1.3 + y))});
  }
  return points;
}

/// Finds the distance to the nearest segment among those around the previous nearest one.
class Nearest {
 public:
  explicit Nearest(const std::vector<Point>& points) : points_(points) {}
  double operator()(const Point& at) {
    constexpr std::size_t before = 60, after = 120;
    double least = std::numeric_limits<double>::infinity();
    const std::size_t from = last_ > before ? last_ - before : 0, end = std::min(points_.size() - 1, last_ + after);
    for (std::size_t i = from; i < end; ++i) {
      double along = 0, squares = 0, off = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        const double d = points_[i + 1][a] - points_[i][a];
        squares += d * d, along += d * (at[a] - points_[i][a]);
      }
      const double part = squares > 0 ? std::clamp(along / squares, 0.0, 1.0) : 0;
      for (std::size_t a = 0; a < 3; ++a) off += std::pow(at[a] - points_[i][a] - part * (points_[i + 1][a] - points_[i][a]), 2);
      if (off < least) least = off, last_ = i;
    }
    return std::sqrt(least);
  }

 private:
  const std::vector<Point>& points_;
  std::size_t last_ = 0;
};

class PlannerSurface : public testing::TestWithParam<Surface> {};

TEST_P(PlannerSurface, IsWithinToleranceAndLimitsEverywhere) {
  const std::vector<Point> points = points_of(GetParam());
  const MotionLimits limits = test::three_axes(200, 1000, 20000);
  Nearest nearest(points);
  test::Looked looked;
  double farthest = 0;
  Planner planner(limits, [&](const TimedCells& cells) {
    looked.take(cells, limits, [&](const Point& at) { farthest = std::max(farthest, nearest(at)); });
  });
  planner.begin(points.front().data());
  for (const Point& to : points) planner.line_to(to.data(), GetParam().feed, tolerance, false, 0);
  planner.stop();
  EXPECT_EQ(planner.failures(), 0U);
  EXPECT_EQ(looked.unsolved, 0U);
  EXPECT_LE(farthest, tolerance * 1.005);
  EXPECT_LE(looked.speed, 1.001);
  EXPECT_LE(looked.acceleration, 1.01);
  EXPECT_LE(looked.jerk, 1.03);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, PlannerSurface,
                         testing::Values(Surface{"short", 0.1, 1e4, 50}, Surface{"rough", 0.1, 1e3, 50}, Surface{"fast", 0.1, 1e4, 200},
                                         Surface{"coarse", 0.5, 1e3, 100, 2000}, Surface{"tiny", 0.02, 1e4, 30},
                                         Surface{"wide", 1.0, 1e4, 200, 2000}),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace kadr::planner_surface_test
