// motion/least_time/smoothing: smooths straight segments under G5.1. NCT 4.7, 4.7.1.

#include "motion/least_time/smoothing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/tolerance.h"

namespace kadr::smoothing_test {
namespace {

constexpr double own = 0.01;  // mm: tolerance of corners that are not smoothed

struct Out {
  Axes to;
  double tolerance;
  bool on_curve;
};

std::vector<Out> smoothed(const SmoothingRules& rules, std::uint8_t mode, const std::vector<Axes>& points) {
  std::vector<Out> out;
  const Smoothing::Line line = [&](const Axes& to, double, double tolerance, bool on_curve, std::uint64_t) {
    out.push_back({to, tolerance, on_curve});
  };
  Smoothing smoothing(rules);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) smoothing.take({points[i], points[i + 1], 10, own, 0, mode}, line);
  smoothing.finish(line);
  return out;
}

/// Returns points of a circle, one every 6 degrees; each chord is 1 mm long and at its middle 0.0137 mm off the circle.
std::vector<Axes> circle() {
  std::vector<Axes> points;
  constexpr double radius = 10, step = 6;
  for (int i = 0; i <= 20; ++i) {
    const SinCos at = sincos_deg(i * step);
    points.push_back({radius * at.cos, radius * at.sin});
  }
  return points;
}

SmoothingRules rules(double most, double angle = 30) { return {100, 0, angle, most, 0, most, 0}; }

bool passes(const std::vector<Out>& out, const Axes& point) {
  for (const Out& o : out)
    if (std::hypot(o.to[0] - point[0], o.to[1] - point[1]) < 1e-12) return true;
  return false;
}

TEST(smoothing, q2_goes_through_the_points_along_the_circle) {
  const std::vector<Axes> points = circle();
  const std::vector<Out> out = smoothed(rules(0.05), 2, points);
  EXPECT_GT(out.size(), 3 * points.size());
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_TRUE(passes(out, points[i])) << i;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const bool inner = std::atan2(out[i].to[1], out[i].to[0]) > 0.12 && std::atan2(out[i].to[1], out[i].to[0]) < 1.97;
    if (inner) {
      EXPECT_NEAR(std::hypot(out[i].to[0], out[i].to[1]), 10, 1e-4);
    }
    if (i > 0) {
      EXPECT_EQ(out[i].tolerance, tol::exact_path);
    }
  }
}

// 4.7: N3104 greatest and N3105 least deviation, N3100 greatest and N3101
// least length, N3102 angle: each of them leaves the segments straight.
TEST(smoothing, what_is_beyond_the_parameters_is_straight) {
  const std::vector<Axes> points = circle();
  SmoothingRules tight = rules(0.004), least = rules(0.05), longer = rules(0.05), shorter = rules(0.05);
  least.least = 0.02;
  longer.longest = 1;
  shorter.shortest = 1.1;
  for (const SmoothingRules& r : {tight, least, longer, shorter, rules(0.05, 5), rules(0)}) {
    const std::vector<Out> out = smoothed(r, 2, points);
    EXPECT_GE(out.size(), points.size() - 1);
    for (std::size_t i = 1; i + 2 < points.size(); ++i) EXPECT_TRUE(passes(out, points[i]));
    EXPECT_LE(out.size(), points.size() + 40);  // the two segments at the ends may bend less
  }
}

TEST(smoothing, q3_rounds_the_corners_between_smoothed_pieces) {
  const std::vector<Axes> points{{0, 0}, {1, 0}, {2, 0.1}, {3, 0.3}, {3, 1.3}, {3.1, 2.3}};
  const std::vector<Out> out = smoothed(rules(0.05), 3, points);
  ASSERT_EQ(out.size(), 5U);
  EXPECT_EQ(out[0].tolerance, own);
  EXPECT_EQ(out[1].tolerance, 0.05);
  EXPECT_EQ(out[2].tolerance, own);  // neither segment at the corner of 79 degrees is smoothed
  EXPECT_EQ(out[3].tolerance, own);
  EXPECT_EQ(out[4].tolerance, own);
}

// N3107: segments shorter than this are smoothed at any angle; it is at most 2 · N3106.
TEST(smoothing, q3_smooths_kinks_of_short_pieces) {
  SmoothingRules kinks = rules(0.05, 10);
  kinks.always_below = 0.1;
  const std::vector<Out> out = smoothed(kinks, 3, {{0, 0}, {1, 0}, {1.05, 0.05}, {2, 0.05}});
  ASSERT_EQ(out.size(), 3U);
  EXPECT_EQ(out[1].tolerance, 0.05);
  EXPECT_EQ(out[2].tolerance, 0.05);
}

TEST(smoothing, turning_back_is_a_corner) {
  const std::vector<Out> out = smoothed(rules(0.05, 1e9), 2, {{0, 0}, {1, 0}, {0, 0}});
  ASSERT_EQ(out.size(), 2U);
  EXPECT_EQ(out[1].tolerance, own);
}

TEST(smoothing, rules_of_the_setup) {
  kadr::Setup setup;
  const SmoothingRules none = smoothing_rules(setup, {"X", "Y", "Z"});
  EXPECT_TRUE(std::isinf(none.longest) && std::isinf(none.angle));
  EXPECT_EQ(none.most, 0);
}

}  // namespace
}  // namespace kadr::smoothing_test
