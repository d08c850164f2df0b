// action/plane_spline: Bézier curves, circles as rational splines, random NURBS. LinuxCNC G5, G5.1, G5.2 (spec/linuxcnc 7.7).

#include "action/plane_spline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "choices.h"

namespace kadr::plane_spline_test {
namespace {

using test::Choices;
using test::choices;

constexpr double near = 1e-9;

void expect_at(Vec2 got, Vec2 expected, double within = near) {
  EXPECT_NEAR(got.x, expected.x, within);
  EXPECT_NEAR(got.y, expected.y, within);
}

// y = x² from x = -2 to 2 (the manual's example of G5.1). Its length is x/2·√(1 + 4x²) + asinh(2x)/4 on each side.
TEST(plane_spline, parabola) {
  const PlaneSpline curve({{{-2, 4}}, {{0, -4}}, {{2, 4}}}, 3);
  EXPECT_NEAR(curve.length(), 2 * (std::sqrt(17.0) + std::asinh(4.0) / 4), near);
  expect_at(curve.at(0.5), {0, 0});
  for (const double part : {0.1, 0.25, 0.9}) EXPECT_NEAR(curve.at(part).y, curve.at(part).x * curve.at(part).x, near);
  expect_at(curve.direction(0.5), {1, 0});
  EXPECT_NEAR(curve.curvature(0.5), 2, 1e-6);
  const Box2 box = curve.box(0, 1);
  expect_at(box.least, {-2, 0}, 2e-9);
  expect_at(box.most, {2, 4}, 2e-9);
}

// A quarter of the unit circle has the weights 1, cos 45°, 1.
TEST(plane_spline, circle) {
  const PlaneSpline curve({{{1, 0}}, {{1, 1}, std::sqrt(0.5)}, {{0, 1}}}, 3);
  EXPECT_NEAR(curve.length(), pi / 2, near);
  for (int i = 0; i <= 20; ++i) {
    const double part = i / 20.0, angle = part * pi / 2;
    expect_at(curve.at(part), {std::cos(angle), std::sin(angle)});
    expect_at(curve.direction(part), {-std::sin(angle), std::cos(angle)});
    EXPECT_NEAR(curve.curvature(part), 1, 1e-7);
  }
}

// Uniform clamped knots, order 3 and four points give two parabolas. They meet at the midpoint of the inner control points, in the
// direction from one to the other.
TEST(plane_spline, pieces_of_a_quadratic_b_spline_meet_between_the_control_points) {
  const PlaneSpline curve({{{0, 0}}, {{0, 2}}, {{4, 2}}, {{4, 0}}}, 3);
  expect_at(curve.at(0.5), {2, 2});
  expect_at(curve.direction(0.5), {1, 0});
}

TEST(plane_spline, control_points_that_coincide_leave_a_direction) {
  const PlaneSpline curve({{{0, 0}}, {{0, 0}}, {{0, 0}}, {{3, 4}}}, 4);
  EXPECT_NEAR(curve.length(), 5, 1e-6);
  expect_at(curve.direction(0), {0.6, 0.8}, 1e-6);
  expect_at(curve.direction(1), {0.6, 0.8}, 1e-6);
  expect_at(curve.at(0.4), {1.2, 1.6}, 1e-6);
  const PlaneSpline point({{{1, 1}}, {{1, 1}}, {{1, 1}}}, 3);
  EXPECT_EQ(point.length(), 0);
  EXPECT_EQ(point.at(0.5), (Vec2{1, 1}));
  EXPECT_EQ(point.direction(0.5), (Vec2{}));
}

double real(Choices& choose, double least, double most) { return least + (most - least) * static_cast<double>(choose.below(4096)) / 4095; }

struct RandomSpline {
  std::vector<ControlPoint> points;
  std::size_t order;
};

RandomSpline random_spline(Choices& choose) {
  RandomSpline spline;
  spline.order = 2 + choose.below(5);
  const std::size_t count = spline.order + choose.below(8);
  for (std::size_t i = 0; i < count; ++i) spline.points.push_back({{real(choose, -50, 50), real(choose, -50, 50)}, real(choose, 0.2, 5)});
  return spline;
}

RC_GTEST_PROP(plane_spline, runs_evenly_within_its_box_and_the_other_way_round, ()) {
  Choices choose = choices(80);
  const RandomSpline random = random_spline(choose);
  const PlaneSpline curve(random.points, random.order);
  RC_ASSERT(curve.at(0) == random.points.front().at);
  RC_ASSERT(curve.at(1) == random.points.back().at);

  std::vector<ControlPoint> reversed(random.points.rbegin(), random.points.rend());
  const PlaneSpline back(reversed, random.order);
  RC_ASSERT(std::fabs(back.length() - curve.length()) <= 1e-7 * curve.length());

  constexpr int count = 2000;
  const Box2 box = curve.box(0, 1);
  Box2 sampled{curve.at(0), curve.at(0)};
  double sum = 0;
  Vec2 before = curve.at(0);
  for (int i = 1; i <= count; ++i) {
    const double part = static_cast<double>(i) / count;
    const Vec2 here = curve.at(part);
    RC_ASSERT(length(here - before) <= curve.length() / count * (1 + 1e-6));
    sum += length(here - before);
    sampled.take(here);
    before = here;
    if (i % 100 == 0) RC_ASSERT(length(back.at(1 - part) - here) <= 1e-5);
  }
  RC_ASSERT(std::fabs(sum - curve.length()) <= 0.02 * curve.length());  // at a cusp the chord can be shorter by its whole length
  const double reach = curve.length() / count;
  RC_ASSERT(box.least.x <= sampled.least.x + 1e-8);
  RC_ASSERT(box.most.y >= sampled.most.y - 1e-8);
  RC_ASSERT(box.least.x >= sampled.least.x - reach);
  RC_ASSERT(box.most.y <= sampled.most.y + reach);
}

RC_GTEST_PROP(plane_spline, chords_of_pieces_stay_as_near_as_asked, ()) {
  Choices choose = choices(80);
  const RandomSpline random = random_spline(choose);
  const PlaneSpline curve(random.points, random.order);
  const double finest = choose.one_in(10) ? -3 : -1.5;  // a cusp with a tolerance of 0.001 mm takes seconds
  const double chord = std::pow(10, real(choose, finest, 0)), from = real(choose, 0, 0.5), to = real(choose, 0.5, 1);
  const int count = curve.pieces(from, to, chord);
  const int stride = std::max(1, count / 2000);  // a cusp needs a million segments: only some of each part of the curve are checked
  for (int i = count % stride / 2; i < count; i += stride) {
    const double low = from + (to - from) * i / count, high = from + (to - from) * (i + 1) / count;
    const Vec2 start = curve.at(low), delta = curve.at(high) - start;
    for (int k = 1; k < 8; ++k) {
      const Vec2 off = curve.at(low + (high - low) * k / 8) - start;
      const double along = std::clamp(dot(off, delta) / std::max(dot(delta, delta), 1e-30), 0.0, 1.0);
      RC_ASSERT(length(off - along * delta) <= 1.3 * chord);
    }
  }
}

RC_GTEST_PROP(plane_spline, box_of_a_part_is_that_of_its_points, ()) {
  Choices choose = choices(80);
  const RandomSpline random = random_spline(choose);
  const PlaneSpline curve(random.points, random.order);
  const double from = real(choose, 0, 0.6), to = real(choose, from, 1);
  const Box2 box = curve.box(from, to);
  for (int i = 0; i <= 200; ++i) {
    const Vec2 here = curve.at(from + (to - from) * i / 200);
    RC_ASSERT(here.x >= box.least.x - 1e-7);
    RC_ASSERT(here.x <= box.most.x + 1e-7);
    RC_ASSERT(here.y >= box.least.y - 1e-7);
    RC_ASSERT(here.y <= box.most.y + 1e-7);
  }
}

}  // namespace
}  // namespace kadr::plane_spline_test
