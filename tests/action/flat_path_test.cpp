// action/flat_path: arcs and spirals in a plane. NCT 4.3–4.3.3; values of the golden cases 04-23 … 04-31.

#include "action/flat_path.h"

#include <gtest/gtest.h>

#include "base/integral.h"
#include "choices.h"

namespace kadr::flat_path_test {
namespace {

using test::Choices;
using test::choices;

void expect_point(Vec2 got, Vec2 expected, double within = 1e-6) {
  EXPECT_NEAR(got.x, expected.x, within);
  EXPECT_NEAR(got.y, expected.y, within);
}

TEST(flat_path, line) {
  const FlatPath line = FlatPath::line({1, 2}, {4, 6});
  EXPECT_EQ(line.length(), 5);
  EXPECT_EQ(line.length(12), 13);
  EXPECT_EQ(line.at(0.5), (Vec2{2.5, 4}));
  EXPECT_EQ(line.box().most, (Vec2{4, 6}));
  EXPECT_EQ(line.pieces(0.01), 1);
}

// 04-23, 04-26: R(φ) = 50 − 30·φ/180°.
TEST(flat_path, radius_changes_linearly_with_the_angle) {
  const FlatPath spiral = FlatPath::arc({50, 0}, {-20, 0}, {0, 0}, 0.5);
  expect_point(spiral.at(0.25), {30.052038, 30.052038});
  expect_point(spiral.at(0.5), {0, 35});
  expect_point(spiral.at(0.75), {-19.445436, 19.445436});
  EXPECT_NEAR(spiral.length(), 114.2233, 1e-4);
}

// 04-24: radius 10 at the start, 40 at the end, clockwise.
TEST(flat_path, clockwise) { expect_point(FlatPath::arc({0, 0}, {40, 30}, {8, 6}, -0.5).at(0.5), {-7, 26}); }

// 04-25: R = 90 − 60·φ/900°.
TEST(flat_path, spiral_of_two_and_a_half_turns) {
  const FlatPath spiral = FlatPath::arc({90, 0}, {-30, 0}, {0, 0}, 2.5);
  expect_point(spiral.at(0.2), {-78, 0});
  expect_point(spiral.at(0.4), {66, 0});
  expect_point(spiral.at(0.6), {-54, 0});
  expect_point(spiral.at(0.8), {42, 0});
  EXPECT_NEAR(spiral.length(), 944.5726, 1e-4);
}

// 04-31: four revolutions clockwise, radius from 50 to 20, 20 mm down.
TEST(flat_path, cone) {
  const FlatPath spiral = FlatPath::arc({-50, 0}, {-20, 0}, {0, 0}, -4);
  expect_point(spiral.at(0.0625), {0, 48.125});
  expect_point(spiral.at(0.125), {46.25, 0});
  expect_point(spiral.at(0.75), {-27.5, 0});
  EXPECT_NEAR(spiral.length(), 880.1926, 1e-4);
  EXPECT_NEAR(spiral.length(20), 880.4354, 1e-4);
}

TEST(flat_path, from_the_centre_outwards_the_end_gives_the_direction) {
  const FlatPath spiral = FlatPath::arc({5, 5}, {5, 25}, {5, 5}, 1.25);
  expect_point(spiral.at(0.2), {5, 5 + 4}, 1e-12);  // it starts at 0°; after a quarter turn a fifth of the radius is reached
  expect_point(spiral.at(1), {5, 25}, 0);
  EXPECT_NEAR(spiral.length(), FlatPath::arc({5, 25}, {5, 5}, {5, 5}, -1.25).length(), 1e-12);
}

// A line through the origin sweeps half a turn about it; a circle around the origin sweeps whole turns.
TEST(flat_path, angle_swept_about_the_origin) {
  EXPECT_EQ(FlatPath::line({50, 0}, {-50, 0}).swept(1), 180);
  EXPECT_NEAR(FlatPath::line({50, 1}, {-50, 1}).swept(1), 180 - 2 * std::atan(1 / 50.0) / rad_per_deg, 1e-9);
  EXPECT_NEAR(FlatPath::arc({10, 0}, {10, 0}, {3, 0}, 3).swept(1), 1080, 1e-9);
  EXPECT_NEAR(FlatPath::arc({10, 0}, {10, 0}, {15, 0}, -3).swept(1), 0, 1e-9);
}

/// A random arc or spiral with radii of 0.1 … 100 mm and up to 6 revolutions.
struct RandomSpiral {
  Vec2 from, to, center;
  double turns = 0;
  FlatPath path() const { return FlatPath::arc(from, to, center, turns); }
};

RandomSpiral random_spiral(Choices& choose) {
  RandomSpiral s;
  s.center = {choose.between(-50'000, 50'000) / 1000.0, choose.between(-50'000, 50'000) / 1000.0};
  s.turns = choose.between(1, 6'000) / 1000.0 * (choose.below(2) == 0 ? 1 : -1);
  const double start = choose.between(-180, 180), radius = choose.between(1, 1'000) / 10.0;
  const double end = choose.one_in(3) ? radius * (1 + choose.between(-1, 1) * 1e-6) : choose.between(1, 1'000) / 10.0;
  s.from = s.center + rotated({radius, 0}, start);
  s.to = s.center + rotated({end, 0}, start + 360 * s.turns);
  return s;
}

RC_GTEST_PROP(flat_path, length_is_the_integral_of_its_rate, ()) {
  Choices choose = choices(60);
  const FlatPath path = random_spiral(choose).path();
  const double rise = choose.between(0, 30), length = path.length(rise);
  const double sum = integral([&](double part) { return std::hypot(kadr::length(path.rate(part)), rise); }, 0, 1, 1e-11);
  RC_ASSERT(std::abs(length - sum) <= 1e-9 * length);
}

RC_GTEST_PROP(flat_path, rate_is_the_difference_of_near_points, ()) {
  Choices choose = choices(60);
  const FlatPath path = random_spiral(choose).path();
  const double part = choose.between(10, 990) / 1000.0, step = 1e-6;
  const Vec2 difference = (1 / (2 * step)) * (path.at(part + step) - path.at(part - step));
  RC_ASSERT(length(difference - path.rate(part)) <= 1e-5 * (1 + length(difference)));
}

RC_GTEST_PROP(flat_path, turned_mirrored_reversed_it_keeps_its_length, ()) {
  Choices choose = choices(60);
  const RandomSpiral s = random_spiral(choose);
  const double rise = choose.between(0, 30), angle = choose.between(-360, 360), length = s.path().length(rise);
  const auto same = [&](const FlatPath& other) { return std::abs(other.length(rise) - length) <= 1e-10 * length; };
  const auto mirror = [](Vec2 p) { return Vec2{-p.x, p.y}; };
  RC_ASSERT(same(FlatPath::arc(rotated(s.from, angle), rotated(s.to, angle), rotated(s.center, angle), s.turns)));
  RC_ASSERT(same(FlatPath::arc(mirror(s.from), mirror(s.to), mirror(s.center), -s.turns)));
  RC_ASSERT(same(FlatPath::arc(s.to, s.from, s.center, -s.turns)));
}

RC_GTEST_PROP(flat_path, cut_in_two_it_is_the_same, ()) {
  Choices choose = choices(60);
  const RandomSpiral s = random_spiral(choose);
  const FlatPath whole = s.path();
  const double part = choose.between(1, 99) / 100.0, rise = choose.between(0, 30);
  const Vec2 middle = whole.at(part);
  const FlatPath one = FlatPath::arc(s.from, middle, s.center, s.turns * part);
  const FlatPath two = FlatPath::arc(middle, s.to, s.center, s.turns * (1 - part));
  RC_ASSERT(std::abs(one.length(rise * part) + two.length(rise * (1 - part)) - whole.length(rise)) <= 1e-10 * whole.length(rise));
  const double within = choose.between(0, 100) / 100.0;
  RC_ASSERT(length(one.at(within) - whole.at(part * within)) <= 1e-9);
  RC_ASSERT(length(two.at(within) - whole.at(part + (1 - part) * within)) <= 1e-9);
}

RC_GTEST_PROP(flat_path, box_is_that_of_its_points, ()) {
  Choices choose = choices(60);
  const FlatPath path = random_spiral(choose).path();
  constexpr int steps = 5'000;
  Box2 sampled{path.at(0), path.at(0)};
  for (int i = 1; i <= steps; ++i) sampled.take(path.at(double(i) / steps));
  const Box2 box = path.box();
  const double gap = 0.01;  // the sagitta, 100 mm · (6 revolutions · 2π / 5000)² / 8, is smaller
  for (const double over :
       {sampled.least.x - box.least.x, sampled.least.y - box.least.y, box.most.x - sampled.most.x, box.most.y - sampled.most.y})
    RC_ASSERT(over >= -1e-9 && over <= gap);
}

/// The slow reference of swept() adds the angles between neighbouring points.
RC_GTEST_PROP(flat_path, angle_swept_agrees_with_its_slow_twin, ()) {
  Choices choose = choices(60);
  const RandomSpiral s = random_spiral(choose);
  const FlatPath path = choose.one_in(4) ? FlatPath::line(s.from, s.to) : s.path();
  constexpr int steps = 5'000;
  double sum = 0, nearest = 1e9;
  for (int i = 1; i <= steps; ++i) {
    const Vec2 a = path.at((i - 1.0) / steps), b = path.at(double(i) / steps);
    sum += std::atan2(cross(a, b), dot(a, b)) / rad_per_deg;
    nearest = std::min(nearest, length(b));
    if (i % 500 == 0 && nearest > 0.5) RC_ASSERT(std::abs(path.swept(double(i) / steps) - sum) <= 1e-8);
  }
}

RC_GTEST_PROP(flat_path, pieces_keep_the_chord, ()) {
  Choices choose = choices(60);
  const RandomSpiral s = random_spiral(choose);
  const FlatPath circle = FlatPath::arc(s.from, s.center + rotated(s.from - s.center, 360 * s.turns), s.center, s.turns);
  const double chord = choose.between(1, 1'000) / 1000.0;
  const int n = circle.pieces(chord);
  const Vec2 middle = 0.5 * (circle.at(0) + circle.at(1.0 / n));
  RC_ASSERT(length(circle.at(0.5 / n) - middle) <= chord * 1.001 + 1e-9);
}

}  // namespace
}  // namespace kadr::flat_path_test
