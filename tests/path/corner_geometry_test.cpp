// path/curve/corner_geometry: the slow reference of a rounding rolls a
// circle along the first element until it leaves the second. NCT 17.

#include "path/curve/corner_geometry.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/tolerance.h"

namespace kadr::corner_geometry_test {
namespace {

constexpr double near = 1e-6;  // mm
constexpr CornerRoom any_room{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

double number(double least, double most) { return least + (most - least) * *rc::gen::inRange(0, 1'000'001) / 1e6; }

/// Returns an element from `at` with this tangent: a line, or an arc to the left or to the right.
ContourElement element_from(Vec2 at, Vec2 tangent, bool arc) {
  if (!arc) return ContourElement::line(at, at + number(20, 60) * tangent);
  const double turns = (*rc::gen::arbitrary<bool>() ? 1 : -1) * number(0.1, 0.6);
  const Vec2 center = at + (turns > 0 ? 1 : -1) * number(15, 50) * left_of(tangent);
  return ContourElement::arc(at, center + rotated(at - center, 360 * turns), center, turns);
}

ContourElement reversed(const ContourElement& e) {
  return e.is_arc ? ContourElement::arc(e.to, e.from, e.center, -e.turns) : ContourElement::line(e.to, e.from);
}

/// Two elements that meet at a corner of at least a few degrees.
struct Pair {
  ContourElement first, second;
};
Pair any_pair() {
  const Vec2 corner{number(-50, 50), number(-50, 50)};
  const Vec2 in = rotated({1, 0}, number(0, 360));
  const double turn = (*rc::gen::arbitrary<bool>() ? 1 : -1) * number(5, 170);
  const bool first_arc = *rc::gen::arbitrary<bool>(), second_arc = *rc::gen::arbitrary<bool>();
  return {reversed(element_from(corner, -1.0 * in, first_arc)), element_from(corner, rotated(in, turn), second_arc)};
}

/// Returns the point at `travel` along an element; `travel` is in mm on a line, in revolutions on an arc.
Vec2 point_at(const ContourElement& e, double travel) {
  return e.is_arc ? e.center + rotated(e.from - e.center, 360 * e.sense() * travel) : e.from + travel * e.start;
}
Vec2 tangent_at(const ContourElement& e, double travel) { return e.is_arc ? rotated(e.start, 360 * e.sense() * travel) : e.start; }

/// The distance to the element, and whether the nearest point is not one of its ends.
struct Nearest {
  double distance;
  bool inside;
};
Nearest nearest(const ContourElement& e, Vec2 p) {
  const double ends = std::min(length(p - e.from), length(p - e.to));
  if (e.is_arc) {
    const double turns = swept_turns(e.from - e.center, p - e.center, e.sense());
    const double off_arc = std::fabs(length(p - e.center) - e.start_radius);
    return turns <= whole_travel(e) && off_arc < ends ? Nearest{off_arc, true} : Nearest{ends, false};
  }
  const double along = dot(p - e.from, e.start);
  if (along <= 0 || along >= whole_travel(e)) return {ends, false};
  return {std::fabs(cross(e.start, p - e.from)), true};
}

/// Returns the side of an element on which a point is: positive on the left.
double side_of(const ContourElement& e, Vec2 p) {
  return e.is_arc ? e.sense() * (e.start_radius - length(p - e.center)) : cross(e.start, p - e.from);
}

/// Rolls the circle back along the first element, on the inside of the corner, until it only touches the second element.
std::optional<Vec2> rolled(const Pair& p, double radius) {
  const double side = cross(p.first.end, p.second.start) > 0 ? 1 : -1, whole = whole_travel(p.first);
  const auto center = [&](double back) {
    return point_at(p.first, whole - back) + side * radius * left_of(tangent_at(p.first, whole - back));
  };
  const auto gap = [&](double back) { return nearest(p.second, center(back)).distance - radius; };
  constexpr int steps = 20'000;
  for (int i = 1; i <= steps; ++i) {
    double inner = whole * (i - 1) / steps, outer = whole * i / steps;
    if (gap(outer) <= 0) continue;
    for (int halving = 0; halving < 80; ++halving) {
      const double middle = (inner + outer) / 2;
      (gap(middle) <= 0 ? inner : outer) = middle;
    }
    const Vec2 found = center(inner);
    return nearest(p.second, found).inside && side * side_of(p.second, found) > 0 ? std::optional(found) : std::nullopt;
  }
  return std::nullopt;
}

double distance_from(const ContourElement& e, Vec2 tangent, Vec2 corner, Vec2 p) {
  return e.is_arc ? std::fabs(length(p - e.center) - length(corner - e.center)) : std::fabs(cross(tangent, p - corner));
}

RC_GTEST_PROP(corner_geometry, a_rounding_is_tangent_to_both, ()) {
  const Pair p = any_pair();
  const double radius = number(0.5, 12);
  const auto r = rounding(p.first, p.second, radius, {whole_travel(p.first), whole_travel(p.second)});
  RC_PRE(r.has_value());
  RC_ASSERT(std::fabs(distance_from(p.first, p.first.end, p.first.to, r->center) - radius) < near);
  RC_ASSERT(std::fabs(distance_from(p.second, p.second.start, p.first.to, r->center) - radius) < near);
  RC_ASSERT(length(point_at(p.first, whole_travel(p.first) - r->first_travel) - r->from) < near);
  RC_ASSERT(length(point_at(p.second, r->second_travel) - r->to) < near);
  // The arc begins in the direction of the first element at that point, and ends in the direction of the second.
  const double sense = r->turns > 0 ? 1 : -1;
  RC_ASSERT(dot(sense * left_of(r->from - r->center), tangent_at(p.first, whole_travel(p.first) - r->first_travel)) > radius - near);
  RC_ASSERT(dot(sense * left_of(r->to - r->center), tangent_at(p.second, r->second_travel)) > radius - near);
  RC_ASSERT(std::fabs(r->turns) < 1);
}

RC_GTEST_PROP(corner_geometry, a_rounding_is_where_a_rolled_circle_rests, ()) {
  const Pair p = any_pair();
  const double radius = number(0.5, 8);
  const auto slow = rolled(p, radius);
  RC_PRE(slow.has_value());
  const auto r = rounding(p.first, p.second, radius, {whole_travel(p.first), whole_travel(p.second)});
  RC_ASSERT(r.has_value());
  RC_ASSERT(length(r->center - *slow) < 1e-4);  // near tangency the reference's step is coarser than its bisection
}

RC_GTEST_PROP(corner_geometry, two_lines_lose_r_times_the_tangent_of_half_the_angle, ()) {
  const double turn = number(1, 179), radius = number(0.1, 20);
  const Vec2 in = rotated({1, 0}, number(0, 360));
  const ContourElement first = ContourElement::line(-300.0 * in, {}), second = ContourElement::line({}, 300 * rotated(in, turn));
  const auto r = rounding(first, second, radius, any_room);
  RC_ASSERT(r.has_value());
  const double expected = radius * std::tan(turn / 2 * rad_per_deg);
  RC_ASSERT(std::fabs(r->first_travel - expected) < near * (1 + expected));
  RC_ASSERT(std::fabs(r->second_travel - expected) < near * (1 + expected));
  RC_ASSERT(std::fabs(r->turns - turn / 360) < near);
}

RC_GTEST_PROP(corner_geometry, the_legs_of_a_chamfer_are_chords, ()) {
  const Pair p = any_pair();
  const double leg = number(0.1, 12);
  const auto c = chamfer(p.first, p.second, leg);
  RC_ASSERT(c.has_value());
  RC_ASSERT(std::fabs(length(c->from - p.first.to) - leg) < near);
  RC_ASSERT(std::fabs(length(c->to - p.first.to) - leg) < near);
  RC_PRE(c->first_travel < whole_travel(p.first) && c->second_travel < whole_travel(p.second));
  RC_ASSERT(length(point_at(p.first, whole_travel(p.first) - c->first_travel) - c->from) < near);
  RC_ASSERT(length(point_at(p.second, c->second_travel) - c->to) < near);
}

TEST(corner_geometry, a_leg_longer_than_the_diameter) {
  const auto arc = ContourElement::arc({0, 0}, {0, 4}, {0, 2}, 0.5);
  EXPECT_FALSE(chamfer(ContourElement::line({-10, 1}, {0, 0}), arc, 4.001));
  EXPECT_TRUE(chamfer(ContourElement::line({-10, 1}, {0, 0}), arc, 4));
}

TEST(corner_geometry, no_rounding_inside_an_arc_of_its_size) {
  const auto line = ContourElement::line({-50, 0}, {30, 0});
  const auto arc = ContourElement::arc({30, 0}, {0, 30}, {0, 0}, 0.25);
  EXPECT_TRUE(rounding(line, arc, 8, any_room));
  EXPECT_FALSE(rounding(line, arc, 30, any_room));
  EXPECT_FALSE(rounding(line, arc, 31, any_room));
}

TEST(corner_geometry, where_nothing_turns_nothing_is_rounded) {
  const auto line = ContourElement::line({0, 0}, {10, 0});
  EXPECT_TRUE(meet_smoothly(line, ContourElement::line({10, 0}, {20, 0})));
  EXPECT_FALSE(meet_smoothly(line, ContourElement::line({10, 0}, {0, 0})));
  EXPECT_FALSE(rounding(line, ContourElement::line({10, 0}, {0, 0}), 1, any_room));
}

// ---- calculated corners

Support any_support(bool circle) {
  Support s;
  s.is_circle = circle;
  s.center = {number(-20, 20), number(-20, 20)};
  s.radius = number(10, 40);
  const Vec2 direction = rotated({1, 0}, number(0, 360));
  s.direction = direction;
  s.point = circle ? s.center + s.radius * direction : Vec2{number(-20, 20), number(-20, 20)};
  return s;
}
double off(const Support& s, Vec2 p) {
  return s.is_circle ? std::fabs(length(p - s.center) - s.radius) : std::fabs(cross(s.direction, p - s.point));
}

RC_GTEST_PROP(corner_geometry, a_calculated_corner_lies_on_both, ()) {
  const Support first = any_support(*rc::gen::arbitrary<bool>()), second = any_support(*rc::gen::arbitrary<bool>());
  const auto near_one = calculated_corner(first, second, {false, false}), far_one = calculated_corner(first, second, {true, false});
  RC_ASSERT(near_one.has_value() == far_one.has_value());
  RC_PRE(near_one.has_value());
  const double size = 1 + length(*near_one) + length(*far_one);
  for (const Vec2 p : {*near_one, *far_one}) {
    RC_ASSERT(off(first, p) < near * size);
    RC_ASSERT(off(second, p) < near * size);
  }
  if (first.is_circle != second.is_circle) {  // the near corner is the one that is met first
    const Support& line = first.is_circle ? second : first;
    RC_ASSERT(dot(*near_one, line.direction) <= dot(*far_one, line.direction) + near);
  }
}

RC_GTEST_PROP(corner_geometry, mirrored_contours_have_mirrored_corners, ()) {
  const Support first = any_support(*rc::gen::arbitrary<bool>()), second = any_support(*rc::gen::arbitrary<bool>());
  const bool farther = *rc::gen::arbitrary<bool>();
  const auto mirrored = [](Support s) {
    s.point.x = -s.point.x;
    s.direction.x = -s.direction.x;
    s.center.x = -s.center.x;
    return s;
  };
  const auto corner = calculated_corner(first, second, {farther, false});
  const auto image = calculated_corner(mirrored(first), mirrored(second), {farther, true});
  RC_ASSERT(corner.has_value() == image.has_value());
  if (!corner) return;
  RC_ASSERT(length(*image - Vec2{-corner->x, corner->y}) < near * (1 + length(*corner)));
}

TEST(corner_geometry, clockwise_on_the_first_circle) {  // golden 17-17, 17-18
  Support first, second;
  first.is_circle = second.is_circle = true;
  first.point = {180, 10};
  first.center = {130, 10};
  first.radius = 50;
  second.center = {50, 30};
  second.radius = 70;
  EXPECT_NEAR(calculated_corner(first, second, {false, false})->x, 93.8614, 1e-4);
  EXPECT_NEAR(calculated_corner(first, second, {true, false})->x, 114.3739, 1e-4);
}

TEST(corner_geometry, parallel_concentric_apart) {
  Support line, other, circle;
  line.direction = other.direction = {1, 0};
  other.point = {0, 1};
  EXPECT_FALSE(calculated_corner(line, other, {}));
  other.point = {};
  EXPECT_FALSE(calculated_corner(line, other, {}));  // the same line: no point of it is the corner
  circle.is_circle = true;
  circle.center = {0, 10};
  circle.radius = 9.9;
  EXPECT_FALSE(calculated_corner(line, circle, {}));
  circle.radius = 10;
  EXPECT_TRUE(calculated_corner(line, circle, {}));  // the circle touches the line
  EXPECT_FALSE(calculated_corner(circle, circle, {}));
}

}  // namespace
}  // namespace kadr::corner_geometry_test
