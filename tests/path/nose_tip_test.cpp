// path/compensation/nose_tip: the path of a turning tool is that of its imaginary tip. The slow reference is the nose circle at samples of
// this path. fanuc-t 7; the numbers are those of the golden cases ft-056 to ft-067 and ft-156.

#include "path/compensation/nose_tip.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "action/by_kind.h"
#include "contours.h"
#include "path/compensation/radius_compensation.h"
#include "path/curve/plane_distance.h"

namespace kadr::nose_tip_test {
namespace {

using test::any_number;
using test::Contour;

constexpr std::size_t x_axis = 0, z_axis = 1;  // a lathe: the first axis of the plane ZX is Z

/// Compensates the actions one by one, so that actions that were held back must come out in the right order.
std::vector<Action> run(const std::vector<Action>& actions, const Axes& from = {}) {
  RadiusCompensation compensation{ToolPosition{from, from, nullptr}};
  std::vector<Action> all;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    ActionBatch batch;
    batch.add() = actions[i];
    EXPECT_FALSE(compensation.take(batch, i + 1 == actions.size()));
    for (const Action& action : batch) all.push_back(action);
  }
  return all;
}

std::vector<Motion> motions_of(const std::vector<Action>& actions) {
  std::vector<Motion> motions;
  for (const Action& action : actions)
    if (const auto* const m = motion_of(action)) motions.push_back(*m);
  return motions;
}

Action action_of(const Motion& m) { return test::action(m); }
template <class What>
Action other(What what) {
  Action a = test::action(Motion{});
  a.what = what;
  return a;
}

/// A turning program. Points are (Z, X); X is a radius.
struct Turning {
  std::int8_t side;
  double radius;
  std::uint8_t nose;
  Vec2 at;
  std::vector<Action> actions{};

  Axes axes(Vec2 p) const {
    Axes to{};
    to[z_axis] = p.x;
    to[x_axis] = p.y;
    return to;
  }
  Motion& add(MotionKind kind, Vec2 to, std::int8_t on_side) {
    Motion m;
    m.kind = kind;
    m.first = z_axis;
    m.second = x_axis;
    m.named = 1U << z_axis | 1U << x_axis;
    m.to = m.machine = axes(to);
    m.side = on_side;
    m.tool_radius = radius;
    m.nose = nose;
    m.entry = CompensationApproach::square;
    at = to;
    actions.push_back(action_of(m));
    return std::get<Motion>(actions.back().what);
  }
  Turning& begin(Vec2 to) { return add(MotionKind::rapid, to, side).side_step = SideStep::begins, *this; }
  Turning& line(Vec2 to) { return add(MotionKind::feed, to, side), *this; }
  Turning& arc(MotionKind kind, Vec2 to, Vec2 center, double turns) {
    Motion& m = add(kind, to, side);
    m.center = center;
    m.turns = turns;
    return *this;
  }
  Turning& end(Vec2 to) { return add(MotionKind::rapid, to, 0).side_step = SideStep::ends, *this; }
};

struct Shown {
  Vec2 to;
  std::optional<Vec2> center{};
};

/// Checks the points (Z, X) of the tip's path, and the centres of its arcs.
void expect_path(const Turning& program, Vec2 from, const std::vector<Shown>& expected) {
  const auto motions = motions_of(run(program.actions, program.axes(from)));
  ASSERT_EQ(motions.size(), expected.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Motion& m = motions[i];
    EXPECT_NEAR(m.to[z_axis], expected[i].to.x, 1e-6) << i;
    EXPECT_NEAR(m.to[x_axis], expected[i].to.y, 1e-6) << i;
    EXPECT_EQ(m.machine, m.to) << i;
    ASSERT_EQ(is_arc(m.kind), expected[i].center.has_value()) << i;
    if (!is_arc(m.kind)) continue;
    EXPECT_NEAR(m.center.x, expected[i].center->x, 1e-6) << i;
    EXPECT_NEAR(m.center.y, expected[i].center->y, 1e-6) << i;
    EXPECT_NEAR(m.turns, 0.25, 1e-9) << i;
  }
}

TEST(nose_tip, the_numbers_of_the_tips) {
  const std::array<Vec2, 11> expected{{{0, 0}, {2, 2}, {-2, 2}, {-2, -2}, {2, -2}, {2, 0}, {0, 2}, {-2, 0}, {0, -2}, {0, 0}, {0, 0}}};
  for (std::size_t nose = 0; nose < expected.size(); ++nose)
    EXPECT_EQ(nose_vector(static_cast<std::uint8_t>(nose), 2), expected[nose]) << nose;
}

TEST(nose_tip, shoulder) {
  Turning t{-1, 2, 3, {5, 25}};
  t.begin({5, 10}).line({-20, 10}).line({-20, 20}).end({5, 25});
  expect_path(t, {5, 25}, {{{3, 10}}, {{-20, 10}}, {{-20, 18}}, {{5, 25}}});
}

TEST(nose_tip, cone_of_45_degrees) {
  Turning t{-1, 2, 3, {5, 25}};
  t.begin({5, 10}).line({-20, 10}).line({-30, 20}).line({-40, 20}).line({-40, 25}).end({5, 30});
  expect_path(t, {5, 25}, {{{3, 10}}, {{-21.171573, 10}}, {{-31.171573, 20}}, {{-40, 20}}, {{-40, 23}}, {{5, 30}}});
}

TEST(nose_tip, face_rounding_cylinder) {
  Turning t{-1, 0.8, 3, {5, 0}};
  t.begin({0, 0}).line({0, 10}).arc(MotionKind::arc_ccw, {-5, 15}, {-5, 10}, 0.25).line({-20, 15}).line({-20, 25}).end({5, 30});
  const Vec2 center{-5.8, 9.2};
  expect_path(t, {5, 0}, {{{0, -0.8}}, {{0, 9.2}}, {{-5.8, 15}, center}, {{-20, 15}}, {{-20, 24.2}}, {{5, 30}}});
}

TEST(nose_tip, fillet) {
  Turning t{-1, 0.8, 3, {5, 25}};
  t.begin({5, 10}).line({-15, 10}).arc(MotionKind::arc_cw, {-20, 15}, {-15, 15}, 0.25).line({-20, 25}).end({5, 30});
  expect_path(t, {5, 25}, {{{4.2, 10}}, {{-15.8, 10}}, {{-20, 14.2}, Vec2{-15.8, 14.2}}, {{-20, 24.2}}, {{5, 30}}});
}

TEST(nose_tip, boring) {
  Turning t{1, 2, 2, {5, 10}};
  t.begin({5, 20}).line({-20, 20}).line({-20, 10}).end({5, 9});
  expect_path(t, {5, 10}, {{{3, 20}}, {{-20, 20}}, {{-20, 12}}, {{5, 9}}});
}

TEST(nose_tip, facing_beyond_the_axis) {
  Turning t{1, 2, 3, {5, 25}};
  t.begin({0, 22}).line({0, 0}).end({5, 0});
  expect_path(t, {5, 25}, {{{0, 20}}, {{0, -2}}, {{5, 0}}});
}

TEST(nose_tip, a_tip_below_the_centre_moves_along_x_only) {
  Turning t{-1, 2, 8, {5, 25}};
  t.begin({5, 10}).line({-20, 10}).line({-20, 20}).end({5, 25});
  expect_path(t, {5, 25}, {{{5, 10}}, {{-18, 10}}, {{-18, 18}}, {{5, 25}}});
}

TEST(nose_tip, without_a_radius_the_path_is_as_programmed) {
  Turning t{-1, 0, 3, {5, 25}};
  t.begin({5, 10}).line({-20, 10}).line({-20, 20}).end({5, 25});
  expect_path(t, {5, 25}, {{{5, 10}}, {{-20, 10}}, {{-20, 20}}, {{5, 25}}});
}

TEST(nose_tip, outside_corner) {
  Turning t{-1, 1, 3, {5, 5}};
  t.begin({0, 10}).line({0, 15}).line({-20, 15}).line({-20, 25}).end({5, 30});
  expect_path(t, {5, 5}, {{{0, 9}}, {{0, 15}}, {{-20, 15}}, {{-20, 24}}, {{5, 30}}});
}

// The figure of ft-156 ends without a block that cancels compensation: it ends square to its last block (fanuc-t 9.11).
TEST(nose_tip, figure_of_a_cycle) {
  Turning t{-1, 2, 3, {2, 20}};
  t.begin({2, 10}).line({-20, 10}).line({-30, 15}).line({-30, 17});
  expect_path(t, {2, 20}, {{{0, 10}}, {{-21.527864, 10}}, {{-30, 14.236068}}, {{-30, 15}}});
}

// At an outside corner too, the start-up block ends square to the next block, and the last block square to its own end (type A, 7.3).
TEST(nose_tip, square_start_and_end_at_outside_corners) {
  Turning t{1, 2, 3, {5, 25}};
  t.begin({5, 10}).line({-20, 10}).line({-20, 20}).end({5, 25});
  // centres: (5, 8), (-22, 8), (-22, 20)
  expect_path(t, {5, 25}, {{{3, 6}}, {{-24, 6}}, {{-24, 18}}, {{5, 25}}});
}

TEST(nose_tip, an_acute_corner_gets_two_points) {
  Turning t{-1, 1, 3, {10, 10}};
  t.begin({0, 10}).line({0, 20}).line({-4, 17}).line({-14, 17});
  // n1 = (1, 0), t1 = (0, 1); n2 = (-0.6, 0.8), t2 = (-0.8, -0.6): centres (1, 21) and (0.2, 21.4); the tip is (-1, -1) from them
  const auto motions = motions_of(run(t.actions, t.axes({10, 10})));
  ASSERT_EQ(motions.size(), 5U);
  EXPECT_NEAR(motions[1].to[z_axis], 0, 1e-9);
  EXPECT_NEAR(motions[1].to[x_axis], 20, 1e-9);
  EXPECT_NEAR(motions[2].to[z_axis], -0.8, 1e-9);
  EXPECT_NEAR(motions[2].to[x_axis], 20.4, 1e-9);
}

// A new T in G41, G42: the end of its block has the new radius and the new tip.
TEST(nose_tip, a_new_tool_acts_at_the_next_junction) {
  Turning t{-1, 2, 3, {5, 25}};
  t.begin({5, 10}).line({-10, 10});
  t.radius = 1;
  t.nose = 8;
  t.line({-20, 10}).line({-20, 20}).end({5, 25});
  expect_path(t, {5, 25}, {{{3, 10}}, {{-12, 10}}, {{-19, 10}}, {{-19, 19}}, {{5, 25}}});
}

// A new tool in the block of an arc: the arc begins with the old vectors and ends with the new ones.
TEST(nose_tip, a_new_tool_in_an_arc_gives_a_spiral) {
  Turning t{-1, 2, 3, {5, 0}};
  t.begin({0, 0}).line({0, 10});
  t.radius = 1;
  t.arc(MotionKind::arc_ccw, {-5, 15}, {-5, 10}, 0.25).line({-20, 15});
  const auto motions = motions_of(run(t.actions, t.axes({5, 0})));
  ASSERT_EQ(motions.size(), 4U);
  EXPECT_NEAR(motions[1].to[z_axis], 0, 1e-9);
  EXPECT_NEAR(motions[1].to[x_axis], 8, 1e-9);
  const Motion& arc = motions[2];
  EXPECT_EQ(arc.kind, MotionKind::arc_ccw);
  EXPECT_NEAR(arc.to[z_axis], -6, 1e-9);
  EXPECT_NEAR(arc.to[x_axis], 15, 1e-9);
  EXPECT_NEAR(arc.center.x, -7, 1e-9);
  EXPECT_NEAR(arc.center.y, 8, 1e-9);
  const Vec2 start = Vec2{0, 8} - arc.center, end = Vec2{-6, 15} - arc.center;
  EXPECT_NEAR(arc.turns * 360, angle_deg(end) - angle_deg(start), 1e-9);
}

TEST(nose_tip, g40_alone_moves_the_tip_to_its_point) {
  Turning t{-1, 2, 3, {5, 25}};
  t.begin({5, 10}).line({-20, 10});
  t.actions.push_back(other(CompensationBreak{true}));
  expect_path(t, {5, 25}, {{{3, 10}}, {{-22, 10}}, {{-20, 10}}});
}

// G28, G53, G50: the vector is dropped at the end of the block before; the tip is at its point.
TEST(nose_tip, an_interruption_drops_the_vector) {
  Turning t{-1, 2, 3, {5, 25}};
  t.begin({5, 10}).line({-10, 10});
  t.actions.push_back(other(CompensationBreak{}));
  t.line({-20, 10}).line({-20, 20}).end({5, 25});
  expect_path(t, {5, 25}, {{{3, 10}}, {{-10, 10}}, {{-20, 10}}, {{-20, 18}}, {{5, 25}}});
}

// The vector to the centre and the vector to the tip cancel each other: the tip is at its programmed point, but compensation goes on.
TEST(nose_tip, vectors_that_cancel_each_other) {
  RadiusCompensation compensation{ToolPosition{}};
  Turning t{-1, 2, 8, {}};
  t.begin({-10, 0}).line({-20, 0});
  ActionBatch batch;
  for (const Action& action : t.actions) batch.add() = action;
  ASSERT_FALSE(compensation.take(batch, true));
  ASSERT_EQ(batch.size(), 2U);
  for (const Action& action : batch) EXPECT_NEAR(motion_of(action)->to[x_axis], 0, 1e-12);
  EXPECT_TRUE(compensation.off_contour());
  Turning next{0, 2, 8, {-20, 0}};
  next.line({-20, 5});
  batch.clear();
  for (const Action& action : next.actions) batch.add() = action;
  ASSERT_FALSE(compensation.take(batch, true));
  EXPECT_NEAR(motion_of(*batch.begin())->to[x_axis], 5, 1e-12);
  EXPECT_FALSE(compensation.off_contour());
}

// G39: the corner arc is about the programmed point plus the vector to the tip.
TEST(nose_tip, corner_arc) {
  Turning t{-1, 1, 3, {5, 5}};
  t.begin({0, 10}).line({0, 15});
  t.actions.push_back(other(CompensationCorner{}));
  t.line({-20, 15});
  expect_path(t, {5, 5}, {{{0, 9}}, {{0, 14}}, {{-1, 15}, Vec2{-1, 14}}, {{-21, 15}}});
}

// A motion of another axis keeps both vectors.
TEST(nose_tip, motions_outside_the_plane_keep_the_vectors) {
  Turning t{-1, 2, 3, {5, 25}};
  t.begin({5, 10}).line({-20, 10});
  Motion third = std::get<Motion>(t.actions.back().what);
  third.named = 1U << 2;
  third.to[2] = third.machine[2] = 7;
  t.actions.push_back(action_of(third));
  t.line({-20, 20}).end({5, 25});
  const auto motions = motions_of(run(t.actions, t.axes({5, 25})));
  ASSERT_EQ(motions.size(), 5U);
  EXPECT_NEAR(motions[2].to[z_axis], -20, 1e-9);
  EXPECT_NEAR(motions[2].to[x_axis], 10, 1e-9);
  EXPECT_EQ(motions[2].to[2], 7);
}

/// A random contour with its entry and exit. Corners may be inside, outside or tangential.
Contour any_contour(std::int8_t side, double radius) {
  Contour c;
  c.line(20, side, radius).side_step = SideStep::begins;
  for (int i = *rc::gen::inRange(1, 8); i > 0; --i) {
    c.direction = rotated(c.direction, any_number(-60, 140));
    if (*rc::gen::arbitrary<bool>()) c.line(any_number(20, 60), side, radius);
    else c.arc(any_number(10, 60), any_number(-300, 300) / 1000 + 0.0005, side, radius);
  }
  c.line(20, 0, radius).side_step = SideStep::ends;
  return c;
}

/// Compensates the motions; nullopt after an alarm, for example if the offsets do not meet.
std::optional<std::vector<Motion>> compensated(const std::vector<Motion>& motions) {
  RadiusCompensation compensation{ToolPosition{}};
  ActionBatch batch;
  for (const Motion& m : motions) batch.add() = action_of(m);
  if (compensation.take(batch, true)) return std::nullopt;
  return motions_of({batch.begin(), batch.end()});
}

std::vector<Motion> with_nose(std::vector<Motion> motions, std::uint8_t nose, CompensationApproach entry) {
  for (Motion& m : motions) {
    m.nose = nose;
    m.entry = entry;
  }
  return motions;
}

RC_GTEST_PROP(nose_tip, the_tips_path_is_that_of_the_centre_moved_by_one_vector, ()) {
  const auto side = *rc::gen::element<std::int8_t>(1, -1);
  const auto nose = static_cast<std::uint8_t>(*rc::gen::inRange(0, 10));
  const auto entry = *rc::gen::element(CompensationApproach::by_corner, CompensationApproach::square, CompensationApproach::normal);
  const double radius = any_number(1, 3);
  const Contour c = any_contour(side, radius);
  const auto centre = compensated(with_nose(c.motions, 0, entry)), tip = compensated(with_nose(c.motions, nose, entry));
  RC_ASSERT(centre.has_value() == tip.has_value());
  if (!centre) return;
  RC_ASSERT(centre->size() == tip->size());
  const Vec2 by = nose_vector(nose, radius);
  for (std::size_t i = 0; i < centre->size(); ++i) {
    const Motion &a = (*centre)[i], &b = (*tip)[i];
    RC_ASSERT(a.kind == b.kind);
    const Vec2 expected = i + 1 < centre->size() ? by : Vec2{};  // at the end of the exit, the tip is at the programmed point
    RC_ASSERT(length(Vec2{b.to[0] - a.to[0], b.to[1] - a.to[1]} - expected) < 1e-9);
    if (is_arc(a.kind)) RC_ASSERT(length(b.center - a.center - by) < 1e-9 && a.turns == b.turns);
  }
}

PlanePiece piece_of(const Motion& m, Vec2 from) {
  const Vec2 to{m.to[0], m.to[1]};
  if (!is_arc(m.kind)) return PlanePiece::line(from, to);
  return PlanePiece::arc(from, to, m.center, m.kind == MotionKind::arc_ccw ? m.turns : -m.turns);
}

// The slow twin: the nose circle at samples of the tip's path touches the contour and does not cut it.
RC_GTEST_PROP(nose_tip, the_nose_touches_the_contour_and_does_not_cut_it, ()) {
  const auto side = *rc::gen::element<std::int8_t>(1, -1);
  const auto nose = static_cast<std::uint8_t>(*rc::gen::inRange(0, 10));
  const double radius = any_number(1, 5);
  const std::array<bool, 2> arc{*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
  const int most = arc[0] || arc[1] ? 60 : 140;  // at most this angle keeps the elements apart
  Contour c;
  c.line(20, side, radius).side_step = SideStep::begins;
  for (std::size_t i = 0; i < arc.size(); ++i) {
    if (arc[i]) c.arc(any_number(40, 80), *rc::gen::element(0.2, -0.2), side, radius);
    else c.line(any_number(60, 100), side, radius);
    if (i == 0) c.direction = rotated(c.direction, any_number(-most, most));
  }
  c.line(20, 0, radius).side_step = SideStep::ends;
  const auto path = compensated(with_nose(c.motions, nose, CompensationApproach::square));
  RC_ASSERT(path.has_value());
  std::vector<PlanePiece> contour;
  Vec2 at{20, 0};
  for (std::size_t i = 1; i + 1 < c.motions.size(); ++i) {
    contour.push_back(piece_of(c.motions[i], at));
    at = {c.motions[i].to[0], c.motions[i].to[1]};
  }
  const auto nearest = [&](Vec2 p) {
    double least = 1e9;
    for (const PlanePiece& piece : contour) least = std::min(least, distance(PlanePiece::line(p, p), piece));
    return least;
  };
  const Vec2 by = nose_vector(nose, radius);
  const std::vector<Motion> cutting(path->begin() + 1, path->end() - 1);
  std::size_t touching = 0, all = 0;
  for (const Vec2 tip : test::sampled(cutting, path->front().to)) {
    const double gap = nearest(tip - by) - radius;
    RC_ASSERT(gap > -10 * tol::same_point);
    RC_ASSERT(gap < 1.3 * radius);  // an acute corner: at most √5 radii from the corner
    touching += std::fabs(gap) < 10 * tol::same_point ? 1 : 0;
    ++all;
  }
  RC_ASSERT(2 * touching > all);  // only on the way around the corner does the nose leave the contour
}

// A mirrored program with the mirrored tip on the other side gives the mirrored path.
RC_GTEST_PROP(nose_tip, a_mirrored_program_gives_the_mirrored_path, ()) {
  constexpr std::array<std::uint8_t, 10> mirrored_nose{0, 4, 3, 2, 1, 5, 8, 7, 6, 9};
  const auto side = *rc::gen::element<std::int8_t>(1, -1);
  const auto nose = static_cast<std::uint8_t>(*rc::gen::inRange(0, 10));
  const double radius = any_number(1, 3);
  const Contour c = any_contour(side, radius);
  std::vector<Motion> mirrored = with_nose(c.motions, mirrored_nose[nose], CompensationApproach::square);
  for (Motion& m : mirrored) {
    m.to[1] = -m.to[1];
    m.machine = m.to;
    m.center.y = -m.center.y;
    m.side = static_cast<std::int8_t>(-m.side);
    if (is_arc(m.kind)) m.kind = m.kind == MotionKind::arc_cw ? MotionKind::arc_ccw : MotionKind::arc_cw;
  }
  const auto path = compensated(with_nose(c.motions, nose, CompensationApproach::square)), other_path = compensated(mirrored);
  RC_ASSERT(path.has_value() == other_path.has_value());
  if (!path) return;
  RC_ASSERT(path->size() == other_path->size());
  for (std::size_t i = 0; i < path->size(); ++i) {
    RC_ASSERT(std::fabs((*path)[i].to[0] - (*other_path)[i].to[0]) < 1e-9);
    RC_ASSERT(std::fabs((*path)[i].to[1] + (*other_path)[i].to[1]) < 1e-9);
  }
}

}  // namespace
}  // namespace kadr::nose_tip_test
