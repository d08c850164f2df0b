// action/curve: length, points and extents of lines, arcs and helices, compared with the sampled path as the slow reference.

#include "action/curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "actions.h"

namespace kadr::curve_test {
namespace {

using test::arc;
using test::straight;
using enum MotionKind;

const AxisRoles xyz = AxisRoles::of({"X", "Y", "Z"}, 0);

TEST(axis_roles, are_found_by_name) {
  const AxisRoles roles = AxisRoles::of({"Z", "A", "X"}, 2);
  EXPECT_EQ(roles.xyz, (std::array<int, 3>{2, -1, 0}));
  EXPECT_TRUE(roles.is_rotary(1));
}

TEST(curve, line) {
  const Axes from{1, 2, 3};
  const Motion m = straight(feed, {4, 6, 15});
  const Curve curve(xyz, from, m);
  EXPECT_DOUBLE_EQ(curve.length(), 13);
  EXPECT_EQ(curve.at(0.5), (Axes{2.5, 4, 9}));
  EXPECT_EQ(curve.pieces(0.01), 1);
}

TEST(curve, rotary_axes_go_along_and_have_no_length) {
  const AxisRoles roles = AxisRoles::of({"X", "Y", "Z", "A"}, 8);
  const Axes from{};
  Motion m = straight(feed, {3, 4, 0});
  m.to[3] = 90;
  EXPECT_DOUBLE_EQ(Curve(roles, from, m).length(), 5);
  EXPECT_DOUBLE_EQ(Curve(roles, from, m).rotary_length(), 90);
  EXPECT_DOUBLE_EQ(Curve(roles, from, m).at(0.25)[3], 22.5);
}

TEST(curve, quarter_circle_is_exact_at_quadrants) {
  const Axes from{10, 0, 0};
  const Motion half = arc(arc_ccw, {-10, 0, 0}, {0, 0, 0}, 0.5);
  const Curve curve(xyz, from, half);
  EXPECT_EQ(curve.at(0.5), (Axes{0, 10, 0}));
  EXPECT_EQ(curve.extents().most, (Axes{10, 10, 0}));
  EXPECT_EQ(curve.extents().least, (Axes{-10, 0, 0}));
  EXPECT_DOUBLE_EQ(curve.length(), 10 * pi);
  const Motion other = arc(arc_cw, {-10, 0, 0}, {0, 0, 0}, 0.5);
  EXPECT_EQ(Curve(xyz, from, other).at(0.5), (Axes{0, -10, 0}));
}

// Seen from the positive end of the normal, an arc in G18 turns from Z to X.
TEST(curve, planes_turn_from_their_first_axis_to_the_second) {
  const Axes from{0, 0, 10};
  const Motion zx = arc(arc_ccw, {10, 0, 0}, {}, 0.25, Plane::zx);
  const Axes middle = Curve(xyz, from, zx).at(0.5);
  EXPECT_GT(middle[0], 0);
  EXPECT_GT(middle[2], 0);
  const Axes y_start{0, 10, 0};
  const Motion yz = arc(arc_ccw, {0, 0, 10}, {}, 0.25, Plane::yz);
  EXPECT_GT(Curve(xyz, y_start, yz).at(0.5)[2], 0);
}

TEST(curve, helix) {
  const Axes from{20, 0, 0};
  const Motion m = arc(arc_ccw, {20, 0, -9}, {}, 3);
  const Curve curve(xyz, from, m);
  EXPECT_DOUBLE_EQ(curve.length(), std::hypot(3 * 2 * pi * 20, 9));
  EXPECT_DOUBLE_EQ(curve.at(1.0 / 3)[2], -3);
  EXPECT_EQ(curve.extents().least, (Axes{-20, -20, -9}));
}

// 04-29: axes outside the plane move in proportion to the angle. The length for the feed depends on what the feed is measured along.
TEST(curve, arc_with_two_axes_outside_its_plane) {
  const AxisRoles roles = AxisRoles::of({"X", "Y", "Z", "V"}, 0);
  const Axes from{100, 0, 0, 0};
  Motion m = arc(arc_ccw, {0, -100, 50}, {}, 0.75);
  m.to[3] = 20;
  const Curve curve(roles, from, m);
  const Axes p = curve.at(1.0 / 3);
  EXPECT_NEAR(p[1], 100, 1e-9);
  EXPECT_NEAR(p[2], 50 / 3.0, 1e-9);
  EXPECT_NEAR(p[3], 20 / 3.0, 1e-9);
  EXPECT_NEAR(curve.length(), std::hypot(150 * pi, 50, 20), 1e-9);
  EXPECT_NEAR(curve.length(FeedAlong::arc), 150 * pi, 1e-9);
}

TEST(curve, all_axes_alike_for_the_feed) {  // nct 4.2
  const AxisRoles roles = AxisRoles::of({"Z", "C"}, 2);
  Motion m{};
  m.kind = feed;
  m.to = {100, 45};
  const Axes from{};
  const Curve curve(roles, from, m);
  EXPECT_DOUBLE_EQ(curve.length(FeedAlong::all_axes), std::hypot(100, 45));
  EXPECT_DOUBLE_EQ(curve.length(FeedAlong::path), 100);
  m.to[0] = 0;
  EXPECT_DOUBLE_EQ(Curve(roles, from, m).length(FeedAlong::path), 45);  // NIST 2.1.2.5
}

TEST(curve, rolled_axis_goes_its_signed_way) {  // nct 5.6
  const AxisRoles roles = AxisRoles::of({"X", "C"}, 2);
  const Axes from{0, 350};
  MotionDetail detail;
  detail.rolled = 2;
  detail.travel[1] = 380;
  Motion m{};
  m.to = {10, 10};
  m.detail = std::make_shared<MotionDetail>(detail);
  const Curve curve(roles, from, m);
  EXPECT_DOUBLE_EQ(curve.at(0.5)[1], 540);
  EXPECT_EQ(curve.at(1)[1], 10);
  EXPECT_DOUBLE_EQ(curve.rotary_length(), 380);
  EXPECT_EQ(curve.extents().most[1], 350);
}

/// A motion on the surface of a cylinder: A (degrees) is the first axis, X the second.
struct OnCylinder {
  Axes from{};
  Motion motion;
};

OnCylinder on_cylinder(MotionKind kind, Vec2 from, Vec2 to, double radius) {
  const double mm = radius * rad_per_deg;
  MotionDetail detail;
  detail.surface = PathSurface::cylinder;
  detail.radius = radius;
  detail.flat_from = {from.x * mm, from.y};
  detail.flat_to = {to.x * mm, to.y};
  OnCylinder c;
  c.from = {from.y, 0, 0, from.x};
  c.motion = straight(kind, {to.y, 0, 0}, 500);
  c.motion.to[3] = to.x;
  c.motion.first = 3;
  c.motion.second = 0;
  c.motion.detail = std::make_shared<MotionDetail>(detail);
  return c;
}

const AxisRoles xyza = AxisRoles::of({"X", "Y", "Z", "A"}, 8);

// 04-40: lengths on the surface of radius 28.65 mm.
TEST(curve, lines_on_a_cylinder) {
  const OnCylinder turn = on_cylinder(feed, {0, -10}, {30, -10}, 28.65);
  EXPECT_NEAR(Curve(xyza, turn.from, turn.motion).length(), 15.0011, 1e-4);
  EXPECT_EQ(Curve(xyza, turn.from, turn.motion).rotary_length(), 0);
  const OnCylinder slant = on_cylinder(feed, {240, -57.5}, {275, -27.5}, 28.65);
  const Curve curve(xyza, slant.from, slant.motion);
  EXPECT_NEAR(curve.length(), 34.7318, 1e-4);
  EXPECT_NEAR(curve.at(0.5)[3], 257.5, 1e-9);
  EXPECT_NEAR(curve.at(0.5)[0], -42.5, 1e-9);
}

TEST(curve, arc_on_a_cylinder) {  // 04-40 N120: the centre is in axis units
  OnCylinder c = on_cylinder(arc_ccw, {180, -75}, {240, -57.5}, 28.65);
  c.motion.center = {179.381138, -40.001378};
  c.motion.turns = 0.165266667;
  const Curve curve(xyza, c.from, c.motion);
  EXPECT_NEAR(curve.length(), 36.344, 1e-4);
  const double mm = 28.65 * rad_per_deg;
  for (int i = 0; i <= 10; ++i) {
    const Axes p = curve.at(i / 10.0);
    EXPECT_NEAR(std::hypot((p[3] - 179.381138) * mm, p[0] + 40.001378), 35, 1e-4);
  }
  EXPECT_EQ(curve.at(1), c.motion.to);
  EXPECT_EQ(curve.programmed(0.3), curve.at(0.3));
  EXPECT_EQ(curve.extents().least[0], -75);  // the start is just past the lowest point of the circle
}

// 04-39 N120: a quarter circle about (30, 30) in the programmed plane. 04-50: a line past the centre of rotation.
TEST(curve, polar_interpolation) {
  const AxisRoles roles = AxisRoles::of({"X", "Z", "C"}, 4);
  MotionDetail detail;
  detail.surface = PathSurface::polar;
  detail.flat_from = {50, 30};
  detail.flat_to = {30, 50};
  Motion m = straight(arc_ccw, {}, 1000);
  m.second = 2;
  m.center = {30, 30};
  m.turns = 0.25;
  m.to = {std::sqrt(3400), 5, 59.036243};
  m.detail = std::make_shared<MotionDetail>(detail);
  const Axes from{std::sqrt(3400), -3, 30.963757};
  const Curve curve(roles, from, m);
  EXPECT_NEAR(curve.length(), std::hypot(10 * pi, 8), 1e-9);
  EXPECT_NEAR(curve.length(FeedAlong::arc), 10 * pi, 1e-9);
  const Axes middle = curve.at(0.5), flat = curve.programmed(0.5);
  EXPECT_NEAR(middle[0], std::sqrt(1800) + 20, 1e-9);
  EXPECT_NEAR(middle[2], 45, 1e-6);
  EXPECT_EQ(middle[1], 1);
  EXPECT_NEAR(flat[0], 30 + 20 / std::sqrt(2), 1e-9);
  EXPECT_NEAR(flat[2], 30 + 20 / std::sqrt(2), 1e-9);
  EXPECT_EQ(flat[1], 1);
  EXPECT_NEAR(curve.extents().most[0], middle[0], 1e-9);
  EXPECT_EQ(curve.at(1), m.to);

  detail.flat_from = {50, 1};
  detail.flat_to = {-50, 1};
  Motion line = straight(feed, {}, 1000);
  line.second = 2;
  line.to = {std::sqrt(2501), -3, 178.854237};
  line.detail = std::make_shared<MotionDetail>(detail);
  const Axes start{std::sqrt(2501), -3, 1.145763};
  const Curve past(roles, start, line);
  EXPECT_NEAR(past.extents().least[0], 1, 1e-12);
  EXPECT_EQ(past.nearest(), 0.5);
  EXPECT_NEAR(past.at(0.5)[2], 90, 1e-6);
  EXPECT_GT(past.pieces(0.02), 10);
}

/// A random arc in any plane and direction whose radius grows a little.
struct RandomArc {
  Axes from{};
  Motion motion;
};

RandomArc random_arc() {
  const auto number = [](int least, int most) { return *rc::gen::inRange(least * 1000, most * 1000) / 1000.0; };
  RandomArc a;
  const auto plane = *rc::gen::inRange(0, 3);
  const std::array<std::size_t, 2> in = plane == 0   ? std::array<std::size_t, 2>{0, 1}
                                        : plane == 1 ? std::array<std::size_t, 2>{2, 0}
                                                     : std::array<std::size_t, 2>{1, 2};
  const double radius = number(1, 100), start = number(-180, 180), turns = number(0, 4) + 0.001, grown = radius + number(0, 1) * 0.01;
  const double sign = *rc::gen::arbitrary<bool>() ? 1 : -1;
  std::array<double, 3> center{number(-50, 50), number(-50, 50), number(-50, 50)};
  for (std::size_t i = 0; i < 3; ++i) a.from[i] = a.motion.to[i] = center[i];
  const SinCos s = sincos_deg(start), e = sincos_deg(start + sign * 360 * turns);
  a.from[in[0]] += radius * s.cos;
  a.from[in[1]] += radius * s.sin;
  Axes to{};
  for (std::size_t i = 0; i < 3; ++i) to[i] = center[i] + (i != in[0] && i != in[1] ? number(-30, 30) : 0);
  to[in[0]] += grown * e.cos;
  to[in[1]] += grown * e.sin;
  a.motion = arc(sign > 0 ? arc_ccw : arc_cw, {to[0], to[1], to[2]}, {center[0], center[1], center[2]}, turns, static_cast<Plane>(plane));
  return a;
}

RC_GTEST_PROP(curve, agrees_with_its_sampled_twin, ()) {
  const RandomArc a = random_arc();
  const Curve curve(xyz, a.from, a.motion);
  constexpr int steps = 20'000;
  double length = 0;
  Extents box{a.from, a.from};
  Axes before = a.from;
  for (int i = 1; i <= steps; ++i) {
    const Axes p = curve.at(double(i) / steps);
    length += std::hypot(p[0] - before[0], p[1] - before[1], p[2] - before[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      box.least[k] = std::min(box.least[k], p[k]);
      box.most[k] = std::max(box.most[k], p[k]);
    }
    before = p;
  }
  RC_ASSERT(std::abs(curve.length() - length) < 1e-5 * length + 1e-9);
  const Extents exact = curve.extents();
  for (std::size_t k = 0; k < 3; ++k) {
    RC_ASSERT(std::abs(exact.least[k] - box.least[k]) < 1e-3);
    RC_ASSERT(std::abs(exact.most[k] - box.most[k]) < 1e-3);
  }
}

RC_GTEST_PROP(curve, ends_are_exact, ()) {
  const RandomArc a = random_arc();
  const Curve curve(xyz, a.from, a.motion);
  RC_ASSERT(curve.at(0) == a.from);
  RC_ASSERT(curve.at(1) == a.motion.to);
}

RC_GTEST_PROP(curve, turned_by_a_quarter_it_turns, ()) {
  const auto a = random_arc();
  RC_PRE(a.motion.first == 0);
  const auto turned = [](const Axes& p) { return Axes{-p[1], p[0], p[2]}; };
  Motion m = a.motion;
  m.to = turned(m.to);
  m.center = {-a.motion.center.y, a.motion.center.x};
  const Axes from = turned(a.from);
  const Curve one(xyz, a.from, a.motion), other(xyz, from, m);
  RC_ASSERT(std::abs(one.length() - other.length()) < 1e-9 * (1 + one.length()));
  const Axes p = turned(one.at(0.37)), q = other.at(0.37);
  for (std::size_t k = 0; k < 3; ++k) RC_ASSERT(std::abs(p[k] - q[k]) < 1e-9);
}

RC_GTEST_PROP(curve, mirrored_it_is_the_opposite_arc, ()) {
  const auto a = random_arc();
  RC_PRE(a.motion.first == 0);
  Motion m = a.motion;
  m.kind = a.motion.kind == arc_cw ? arc_ccw : arc_cw;
  m.to[0] = -m.to[0];
  m.center.x = -m.center.x;
  Axes from = a.from;
  from[0] = -from[0];
  const Extents one = Curve(xyz, a.from, a.motion).extents(), other = Curve(xyz, from, m).extents();
  RC_ASSERT(std::abs(one.least[0] + other.most[0]) < 1e-9);
  RC_ASSERT(std::abs(one.most[0] + other.least[0]) < 1e-9);
  RC_ASSERT(std::abs(one.most[1] - other.most[1]) < 1e-9);
}

RC_GTEST_PROP(curve, pieces_keep_the_chord, ()) {
  const auto a = random_arc();
  const Curve curve(xyz, a.from, a.motion);
  const double chord = *rc::gen::inRange(1, 1000) / 1000.0;
  const int n = curve.pieces(chord);
  const Axes p = curve.at(0), q = curve.at(0.5 / n), r = curve.at(1.0 / n);
  double gap = 0;
  for (std::size_t k = 0; k < 3; ++k) gap = std::hypot(gap, q[k] - (p[k] + r[k]) / 2);
  RC_ASSERT(gap <= chord * 1.001 + 0.01);  // the radius grows by 0.01
}

}  // namespace
}  // namespace kadr::curve_test
