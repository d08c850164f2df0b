// control/block/arc: centre, sweep and checks of one arc, compared with points sampled along it. RS274/NGC; 2С42 6.6.4.

#include "control/block/arc.h"

#include "choices.h"

namespace kadr::arc_test {
namespace {

using test::Choices;
using test::choices;

constexpr double tolerance = 0.01;  // mm

struct Asked {
  Vec2 center, from, to;
  double radius = 0, start = 0, sweep = 0;  // degrees, counter-clockwise positive
  Turn turn = Turn::ccw;
};

Vec2 on_circle(Vec2 center, double radius, double deg) { return center + rotated({radius, 0}, deg); }

/// Returns a random arc given by centre, radius and angles; its sweep is from a hundredth of a degree to nearly a whole circle.
Asked random_arc() {
  Choices choose = choices(40);
  Asked a;
  a.turn = choose.below(2) == 0 ? Turn::ccw : Turn::cw;
  a.center = {choose.between(-100'000, 100'000) / 1000.0, choose.between(-100'000, 100'000) / 1000.0};
  a.radius = choose.between(100, 200'000) / 1000.0;
  a.start = choose.between(-180'000, 180'000) / 1000.0;
  a.sweep = choose.between(100, 359'900) / 1000.0 * (a.turn == Turn::ccw ? 1 : -1);
  a.from = on_circle(a.center, a.radius, a.start);
  a.to = on_circle(a.center, a.radius, a.start + a.sweep);
  return a;
}

/// The reference: goes from `from` about the centre in small steps, in the requested direction, until it meets `to`.
double sampled_turns(Vec2 from, Vec2 to, Vec2 center, Turn turn) {
  constexpr int steps = 36'000;
  double nearest = 1e300;
  int best = 0;
  for (int i = 1; i <= steps; ++i) {
    const double angle = (turn == Turn::ccw ? 360.0 : -360.0) * i / steps;
    const double distance = length(center + rotated(from - center, angle) - to);
    if (distance < nearest) nearest = distance, best = i;
  }
  return static_cast<double>(best) / steps;
}

AlarmId alarm_of(const Result<PlaneArc>& arc) { return arc ? no_alarm : arc.error().id; }

TEST(arc_around, quarter_half_and_full_circles) {
  EXPECT_EQ(arc_around({10, 0}, {0, 10}, {0, 0}, Turn::ccw, tolerance)->turns, 0.25);
  EXPECT_EQ(arc_around({10, 0}, {0, 10}, {0, 0}, Turn::cw, tolerance)->turns, 0.75);
  EXPECT_EQ(arc_around({10, 0}, {-10, 0}, {0, 0}, Turn::cw, tolerance)->turns, 0.5);
  EXPECT_EQ(arc_around({10, 0}, {10, 0}, {0, 0}, Turn::cw, tolerance)->turns, 1);
}

TEST(arc_around, alarms) {
  EXPECT_EQ(alarm_of(arc_around({1, 1}, {1, 1}, {1, 1}, Turn::cw, tolerance)), AlarmId::arc_radius_zero);
  const auto mismatch = arc_around({3.05, 0}, {0, 6.82}, {0, 0}, Turn::cw, tolerance);
  ASSERT_EQ(alarm_of(mismatch), AlarmId::radius_mismatch);
  EXPECT_EQ(mismatch.error().args[0].number(), 3.05);
  EXPECT_EQ(mismatch.error().args[1].number(), 6.82);
  EXPECT_TRUE(arc_around({10, 0}, {0, 10.01}, {0, 0}, Turn::ccw, 0.0100001));
  EXPECT_FALSE(arc_around({10, 0}, {0, 10.0101}, {0, 0}, Turn::ccw, tolerance));
  EXPECT_FALSE(arc_around({NAN, 0}, {0, 10}, {0, 0}, Turn::ccw, tolerance));
}

TEST(arc_by_radius, alarms_and_half_circles) {
  EXPECT_EQ(alarm_of(arc_by_radius({1, 1}, {1, 1}, 5, Turn::cw, tolerance)), AlarmId::full_circle_by_radius);
  EXPECT_EQ(alarm_of(arc_by_radius({0, 0}, {10, 0}, 4.9, Turn::cw, tolerance)), AlarmId::radius_too_small);
  EXPECT_EQ(alarm_of(arc_by_radius({0, 0}, {10, 0}, 0, Turn::cw, tolerance)), AlarmId::radius_too_small);
  for (const double radius : {5.0, 4.995, -5.0}) {
    const auto half = arc_by_radius({0, 0}, {10, 0}, radius, Turn::ccw, tolerance);
    ASSERT_TRUE(half);
    EXPECT_EQ(half->turns, 0.5);
    EXPECT_EQ(half->center, (Vec2{5, 0}));
  }
}

RC_GTEST_PROP(arc_around, sweeps_what_was_asked_for, ()) {
  const Asked a = random_arc();
  const auto arc = arc_around(a.from, a.to, a.center, a.turn, tolerance);
  RC_ASSERT(arc.has_value());
  RC_ASSERT(arc->center == a.center);
  RC_ASSERT(std::fabs(arc->turns - std::fabs(a.sweep) / 360) < 1e-9);
}

RC_GTEST_PROP(arc_around, agrees_with_the_sampled_twin, ()) {
  const Asked a = random_arc();
  const auto arc = arc_around(a.from, a.to, a.center, a.turn, tolerance);
  RC_ASSERT(arc.has_value());
  RC_ASSERT(std::fabs(arc->turns - sampled_turns(a.from, a.to, a.center, a.turn)) <= 1.0 / 36'000);
}

RC_GTEST_PROP(arc_around, exchanged_and_opposed_is_the_same_arc_reversed, ()) {
  Asked a = random_arc();
  a.to = a.to + Vec2{*rc::gen::inRange(-5, 6) / 1000.0, 0};  // makes it a spiral within the tolerance
  const auto there = arc_around(a.from, a.to, a.center, a.turn, tolerance);
  const auto back = arc_around(a.to, a.from, a.center, a.turn == Turn::cw ? Turn::ccw : Turn::cw, tolerance);
  RC_ASSERT(there.has_value());
  RC_ASSERT(back.has_value());
  RC_ASSERT(there->center == back->center);
  RC_ASSERT(std::fabs(there->turns - back->turns) <= 1e-12);
}

RC_GTEST_PROP(arc_by_radius, is_the_arc_by_its_centre, ()) {
  const Asked a = random_arc();
  RC_PRE(std::fabs(std::fabs(a.sweep) - 180) > 1 && std::fabs(a.sweep) < 359);  // near a half circle the centre is ill-conditioned
  const double radius = std::fabs(a.sweep) > 180 ? -a.radius : a.radius;
  const auto arc = arc_by_radius(a.from, a.to, radius, a.turn, tolerance);
  RC_ASSERT(arc.has_value());
  RC_ASSERT(length(arc->center - a.center) < 1e-8);
  RC_ASSERT(std::fabs(arc->turns - std::fabs(a.sweep) / 360) < 1e-9);
}

RC_GTEST_PROP(arc_by_radius, lies_at_that_radius_from_both_ends, ()) {
  Choices choose = choices(20);
  const Vec2 from{choose.between(-9999, 9999) / 100.0, choose.between(-9999, 9999) / 100.0};
  const Vec2 to{choose.between(-9999, 9999) / 100.0, choose.between(-9999, 9999) / 100.0};
  RC_PRE(!(from == to));
  const double half = length(to - from) / 2;
  const double radius = half * (1 + choose.between(0, 999) / 100.0) * (choose.below(2) == 0 ? 1 : -1);
  for (const Turn turn : {Turn::cw, Turn::ccw}) {
    const auto arc = arc_by_radius(from, to, radius, turn, tolerance);
    RC_ASSERT(arc.has_value());
    RC_ASSERT(std::fabs(length(arc->center - from) - std::fabs(radius)) < 1e-9 * (1 + half));
    RC_ASSERT(std::fabs(length(arc->center - to) - std::fabs(radius)) < 1e-9 * (1 + half));
    RC_ASSERT(std::fabs(radius) == half || (arc->turns > 0.5) == (radius < 0));
  }
}

RC_GTEST_PROP(arc_by_radius, with_the_other_sign_and_turn_is_the_rest_of_the_circle, ()) {
  const Asked a = random_arc();
  RC_PRE(std::fabs(a.sweep) < 359);
  const auto one = arc_by_radius(a.from, a.to, a.radius, Turn::ccw, tolerance);
  const auto other = arc_by_radius(a.from, a.to, -a.radius, Turn::cw, tolerance);
  RC_ASSERT(one.has_value());
  RC_ASSERT(other.has_value());
  RC_ASSERT(one->center == other->center);
  RC_ASSERT(std::fabs(one->turns + other->turns - 1) < 1e-9);
}

}  // namespace
}  // namespace kadr::arc_test
