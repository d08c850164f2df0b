// action/polar: polar interpolation. NCT 4.5; values of the golden case 04-39.

#include "action/polar.h"

#include <gtest/gtest.h>

#include "choices.h"

namespace kadr::polar_test {
namespace {

using test::Choices;
using test::choices;

void expect_axes(PolarAxes got, double linear, double rotary) {
  EXPECT_NEAR(got.linear, linear, 1e-6);
  EXPECT_NEAR(got.rotary, rotary, 1e-6);
}

// 04-39: the path runs once around the centre; C counts up from block to block to 360.
TEST(polar, contour_of_the_manual) {
  struct Step {
    Vec2 to;
    double linear, rotary;
  };
  const Step steps[] = {{{50, 30}, 58.309519, 30.963757},   {{30, 50}, 58.309519, 59.036243},    {{-20, 50}, 53.851648, 111.801409},
                        {{-50, 20}, 53.851648, 158.198591}, {{-50, -30}, 58.309519, 210.963757}, {{-30, -50}, 58.309519, 239.036243},
                        {{20, -50}, 53.851648, 291.801409}, {{50, -20}, 53.851648, 338.198591},  {{50, 0}, 50, 360}};
  Vec2 from{50, 0};
  double rotary = 0;
  for (const Step& step : steps) {
    const FlatPath path = FlatPath::line(from, step.to);
    const PolarAxes end = PolarPath(path, 1, 0, rotary).at(1);
    expect_axes(end, step.linear, step.rotary);
    from = step.to;
    rotary = end.rotary;
  }
}

TEST(polar, from_the_negative_side) {
  const FlatPath path = FlatPath::line({-50, 0}, {-50, 50});
  expect_axes(PolarPath(path, -1, 0, 0).at(1), -std::sqrt(5000), -45);
}

// p is the offset: with the rotary axis at 0 the tool is at w = p, and the linear axis is at u.
TEST(polar, offset_of_the_centre) {
  const FlatPath path = FlatPath::line({40, 3}, {0, 50});
  const PolarPath polar(path, 1, 3, 0);
  expect_axes(polar.at(0), 40, 0);
  const double linear = std::sqrt(2500.0 - 9);
  expect_axes(polar.at(1), linear, 90 - std::atan2(3, linear) / rad_per_deg);
}

TEST(polar, nearest_point_of_a_line) {
  const FlatPath path = FlatPath::line({50, 1}, {-150, 1});
  EXPECT_EQ(PolarPath(path, 1, 0, 0).nearest(), 0.25);
  const FlatPath away = FlatPath::line({50, 1}, {150, 1});
  EXPECT_EQ(PolarPath(away, 1, 0, 0).nearest(), 0);
}

/// A path that stays clear of the centre, and an offset smaller than its distance from the centre.
struct RandomPolar {
  FlatPath path;
  double side = 1, offset = 0, start = 0, nearest = 0;
};

RandomPolar random_polar(Choices& choose) {
  RandomPolar r;
  const auto number = [&] { return choose.between(-100'000, 100'000) / 1000.0; };
  for (;;) {
    const Vec2 from{number() + 0.5, number()}, center{number(), number()};
    const double turns = choose.between(1, 3'000) / 1000.0 * (choose.below(2) == 0 ? 1 : -1), grown = choose.between(500, 1'500) / 1000.0;
    r.path = choose.below(2) == 0 ? FlatPath::line(from, center)
                                  : FlatPath::arc(from, center + grown * rotated(from - center, 360 * turns), center, turns);
    r.nearest = 1e9;
    for (int i = 0; i <= 1'000; ++i) r.nearest = std::min(r.nearest, length(r.path.at(i / 1000.0)));
    if (r.nearest > 0.5) break;
    if (choose.below(2) == 0) {  // the choices are used up
      r.path = FlatPath::line({50, 0}, {0, 20});
      r.nearest = 18;
      break;
    }
  }
  r.side = choose.below(2) == 0 ? 1 : -1;
  r.offset = choose.one_in(3) ? choose.between(-40, 40) / 100.0 : 0;
  r.start = choose.between(-720, 720);
  return r;
}

/// The slow and obvious reference: follows the path in small steps and chooses each angle within half a turn of the previous one.
PolarAxes slow_twin(const RandomPolar& r, double part) {
  constexpr int steps = 4'000;
  double angle = 0, first = 0, linear = 0;
  for (int i = 0; i <= steps; ++i) {
    const Vec2 p = r.path.at(part * i / steps);
    linear = r.side * std::sqrt(p.x * p.x + p.y * p.y - r.offset * r.offset);
    double now = (std::atan2(r.side * p.y, r.side * p.x) - std::atan2(r.offset, linear)) / rad_per_deg;
    if (i > 0) now += 360 * std::round((angle - now) / 360);
    angle = now;
    if (i == 0) first = now;
  }
  return {linear, r.start + angle - first};
}

RC_GTEST_PROP(polar, agrees_with_its_slow_twin, ()) {
  Choices choose = choices(80);
  const RandomPolar r = random_polar(choose);
  const PolarPath polar(r.path, r.side, r.offset, r.start);
  const double part = choose.between(0, 100) / 100.0;
  const PolarAxes fast = polar.at(part), slow = slow_twin(r, part);
  RC_ASSERT(std::abs(fast.linear - slow.linear) <= 1e-9);
  RC_ASSERT(std::abs(fast.rotary - slow.rotary) <= 1e-8);
}

RC_GTEST_PROP(polar, rates_are_differences_of_near_points, ()) {
  Choices choose = choices(80);
  const RandomPolar r = random_polar(choose);
  const PolarPath polar(r.path, r.side, r.offset, r.start);
  const double part = choose.between(10, 990) / 1000.0, step = 1e-7;
  const PolarAxes before = polar.at(part - step), after = polar.at(part + step), rates = polar.rates(part);
  RC_ASSERT(std::abs((after.linear - before.linear) / (2 * step) - rates.linear) <= 1e-3 * (1 + std::abs(rates.linear)));
  RC_ASSERT(std::abs((after.rotary - before.rotary) / (2 * step) - rates.rotary) <= 1e-2 * (1 + std::abs(rates.rotary)));
}

RC_GTEST_PROP(polar, extremes_are_those_of_its_points, ()) {
  Choices choose = choices(80);
  const RandomPolar r = random_polar(choose);
  const PolarPath polar(r.path, r.side, r.offset, r.start);
  PolarAxes least, most;
  polar.extremes(least, most);
  PolarAxes sampled_least = polar.at(0), sampled_most = polar.at(0);
  for (int i = 1; i <= 3'000; ++i) {
    const PolarAxes p = polar.at(i / 3000.0);
    sampled_least = {std::min(sampled_least.linear, p.linear), std::min(sampled_least.rotary, p.rotary)};
    sampled_most = {std::max(sampled_most.linear, p.linear), std::max(sampled_most.rotary, p.rotary)};
  }
  const double gap = 0.5;  // greatest error from sampling, mm and degrees
  for (const double over : {sampled_least.linear - least.linear, sampled_least.rotary - least.rotary, most.linear - sampled_most.linear,
                            most.rotary - sampled_most.rotary})
    RC_ASSERT(over >= -1e-7 && over <= gap);
}

RC_GTEST_PROP(polar, pieces_of_a_line_keep_the_chord, ()) {
  Choices choose = choices(80);
  const Vec2 from{choose.between(-100, 100) / 1.0, choose.between(-100, 100) / 10.0}, to{choose.between(-100, 100) / 1.0, from.y};
  const FlatPath line = FlatPath::line(from, to);
  const PolarPath polar(line, 1, 0, 0);
  const int n = polar.pieces(0.02);
  for (int i = 0; i < n; ++i) {
    const double middle = (polar.at(double(i) / n).linear + polar.at((i + 1.0) / n).linear) / 2;
    RC_ASSERT(std::abs(polar.at((i + 0.5) / n).linear - middle) <= 0.02 + 1e-9);
  }
}

}  // namespace
}  // namespace kadr::polar_test
