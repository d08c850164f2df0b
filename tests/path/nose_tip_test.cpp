// path/compensation/nose_tip: the path of a turning tool is that of its imaginary tip. fanuc-t 7; the numbers are those of the golden cases
// ft-056 to ft-067 and ft-156. Random contours: tests/path/nose_contour_test.cpp.

#include "path/compensation/nose_tip.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <vector>

#include "action/by_kind.h"
#include "actions.h"
#include "path/compensation/radius_compensation.h"

namespace kadr::nose_tip_test {
namespace {

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

}  // namespace
}  // namespace kadr::nose_tip_test
