// path/compensation/corner_resolver: the stage outputs the programmed contour with its corners cut, whatever the batches are. NCT 17.

#include "path/compensation/corner_resolver.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "action/curve.h"
#include "actions.h"
#include "path/compensation/contour_motion.h"

namespace kadr::corner_resolver_test {
namespace {

using Follows = CornerResolver::Follows;

constexpr double near = 1e-6;  // mm
const AxisRoles xyz = AxisRoles::of({"X", "Y", "Z"}, 0);

double number(double least, double most) { return least + (most - least) * *rc::gen::inRange(0, 1'000'001) / 1e6; }

Motion with(Motion m, const CornerData& c) {
  auto detail = std::make_shared<MotionDetail>();
  detail->contour = c;
  m.detail = std::move(detail);
  m.named = 3;
  return m;
}
Motion line(Vec2 to, double chamfer = 0, double rounding = 0) {
  Motion m = test::straight(MotionKind::feed, {to.x, to.y, 0}, 100);
  m.named = 3;
  return chamfer == 0 && rounding == 0 ? m : with(m, {chamfer, rounding, SupportingCurve::none, {}, 0, false, false});
}
Motion over_line(Vec2 to, double degrees, double rounding = 0) {
  Motion m = with(line(to), {0, rounding, SupportingCurve::line, rotated({1, 0}, degrees), 0, false, false});
  m.side = 1;
  return m;
}
Motion compensated(Motion m) {
  m.side = 1;
  return m;
}

struct Outcome {
  std::vector<Motion> motions;
  std::optional<CompensationFault> fault;
};

/// Sends all motions through the stage in batches of `size`.
Outcome carried(const std::vector<Motion>& motions, std::size_t size = 1, Follows at_end = Follows::nothing) {
  CornerResolver corners{ToolPosition{}};
  Outcome outcome;
  for (std::size_t i = 0; i < motions.size() && !outcome.fault; i += size) {
    ActionBatch batch;
    for (std::size_t k = i; k < std::min(i + size, motions.size()); ++k) {
      Action action = test::action(motions[k], static_cast<std::uint32_t>(k + 1));
      batch.add() = action;
    }
    outcome.fault = corners.take(batch, i + size < motions.size() ? Follows::more : at_end);
    for (const Action& action : batch) outcome.motions.push_back(std::get<Motion>(action.what));
  }
  return outcome;
}

Vec2 end_of(const Motion& m) { return {m.to[0], m.to[1]}; }

/// Returns a contour of lines and arcs, each at least 20 mm long, with corners of 20° to 120°; every corner but the last is cut.
std::vector<Motion> any_contour(std::int8_t side) {
  std::vector<Motion> all;
  Vec2 at, direction{1, 0};
  const auto count = *rc::gen::inRange(2, 7);
  for (int i = 0; i < count; ++i) {
    Motion m;
    if (*rc::gen::arbitrary<bool>()) {
      at = at + number(30, 60) * direction;
      m = line(at);
    } else {
      const double turns = (*rc::gen::arbitrary<bool>() ? 1 : -1) * number(0.1, 0.3);
      const Vec2 center = at + (turns > 0 ? 1 : -1) * number(40, 60) * left_of(direction);
      at = center + rotated(at - center, 360 * turns);
      direction = rotated(direction, 360 * turns);
      m = test::arc(turns > 0 ? MotionKind::arc_ccw : MotionKind::arc_cw, {at.x, at.y, 0}, {center.x, center.y, 0}, std::fabs(turns));
      m.named = 3;
    }
    m.side = side;
    const bool chamfered = *rc::gen::arbitrary<bool>();
    const double size = number(0.5, 3);
    if (i + 1 < count) m = with(m, {chamfered ? size : 0, chamfered ? 0 : size, SupportingCurve::none, {}, 0, false, false});
    direction = rotated(direction, (*rc::gen::arbitrary<bool>() ? 1 : -1) * number(20, 120));
    all.push_back(m);
  }
  return all;
}

double length_of(const std::vector<Motion>& motions) {
  double sum = 0;
  Axes from{};
  for (const Motion& m : motions) {
    sum += Curve(xyz, from, m).length();
    from = m.to;
  }
  return sum;
}

RC_GTEST_PROP(corner_resolver, a_motion_that_is_cut_stays_on_its_element, ()) {
  const auto contour = any_contour(0);
  const Outcome o = carried(contour);
  RC_PRE(!o.fault);
  RC_ASSERT(o.motions.size() == 2 * contour.size() - 1);
  Axes from{}, cut_from{};
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Motion &m = contour[i], &cut = o.motions[2 * i];
    RC_ASSERT(cut.kind == m.kind);
    RC_ASSERT(cut.detail == nullptr);
    const Vec2 a{from[0], from[1]}, b{cut_from[0], cut_from[1]}, c = end_of(cut), d = end_of(m);
    if (is_arc(m.kind)) {  // the parts removed at both corners and the remaining part add up to the programmed motion
      const double sense = sense_of(m);
      const auto turns = [&](Vec2 p, Vec2 q) { return length(q - p) < near ? 0 : swept_turns(p - m.center, q - m.center, sense); };
      for (const Vec2 p : {b, c}) RC_ASSERT(std::fabs(length(p - m.center) - length(d - m.center)) < near);
      RC_ASSERT(std::fabs(turns(a, b) + cut.turns + turns(c, d) - m.turns) < near);
    } else {
      for (const Vec2 p : {b, c}) RC_ASSERT(std::fabs(cross(d - a, p - a)) < near * length(d - a));
      RC_ASSERT(std::fabs(length(b - a) + length(c - b) + length(d - c) - length(d - a)) < near);
    }
    from = m.to;
    if (2 * i + 1 < o.motions.size()) cut_from = o.motions[2 * i + 1].to;
  }
  RC_ASSERT(o.motions.back().to == contour.back().to);
}

RC_GTEST_PROP(corner_resolver, the_size_of_the_batches_does_not_matter, ()) {
  const auto contour = any_contour(*rc::gen::element<std::int8_t>(0, 1));
  const Outcome one = carried(contour, 1), many = carried(contour, static_cast<std::size_t>(*rc::gen::inRange(2, 9)));
  RC_ASSERT(one.fault.has_value() == many.fault.has_value());
  RC_ASSERT(one.motions.size() == many.motions.size());
  for (std::size_t i = 0; i < one.motions.size(); ++i) {
    RC_ASSERT(one.motions[i].kind == many.motions[i].kind);
    RC_ASSERT(one.motions[i].to == many.motions[i].to);
    RC_ASSERT(one.motions[i].turns == many.motions[i].turns);
  }
  if (one.fault) RC_ASSERT(one.fault->origin.line == many.fault->origin.line);
}

RC_GTEST_PROP(corner_resolver, with_compensation_on_the_corners_are_the_same, ()) {
  auto contour = any_contour(0);
  const Outcome off = carried(contour, 3);
  for (Motion& m : contour) m.side = 1;
  const Outcome on = carried(contour, 2);
  RC_PRE(!off.fault);
  RC_ASSERT(!on.fault);
  RC_ASSERT(on.motions.size() == off.motions.size());
  for (std::size_t i = 0; i < on.motions.size(); ++i) {
    RC_ASSERT(length(end_of(on.motions[i]) - end_of(off.motions[i])) < near);
    RC_ASSERT(on.motions[i].side == 1);
  }
}

/// Returns a contour rotated about the origin; with `mirror` it is first mirrored along X.
std::vector<Motion> turned(const std::vector<Motion>& contour, double degrees, bool mirror) {
  const auto image = [&](Vec2 v) { return rotated({mirror ? -v.x : v.x, v.y}, degrees); };
  std::vector<Motion> all;
  for (Motion m : contour) {
    const Vec2 to = image(end_of(m));
    m.to[0] = m.machine[0] = to.x;
    m.to[1] = m.machine[1] = to.y;
    m.center = image(m.center);
    if (mirror && is_arc(m.kind)) m.kind = m.kind == MotionKind::arc_cw ? MotionKind::arc_ccw : MotionKind::arc_cw;
    if (mirror) m.side = static_cast<std::int8_t>(-m.side);
    all.push_back(m);
  }
  return all;
}

RC_GTEST_PROP(corner_resolver, a_turned_contour_has_turned_corners, ()) {
  const auto contour = any_contour(0);
  const double degrees = number(-180, 180);
  const bool mirror = *rc::gen::arbitrary<bool>();
  const Outcome plain = carried(contour), image = carried(turned(contour, degrees, mirror));
  RC_ASSERT(plain.fault.has_value() == image.fault.has_value());
  RC_PRE(!plain.fault);
  const auto expected = turned(plain.motions, degrees, mirror);
  RC_ASSERT(expected.size() == image.motions.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    RC_ASSERT(expected[i].kind == image.motions[i].kind);
    RC_ASSERT(length(end_of(expected[i]) - end_of(image.motions[i])) < near);
    RC_ASSERT(std::fabs(expected[i].turns - image.motions[i].turns) < near);
  }
}

/// Over-determined lines compared with the same contour with its corners worked out by hand.
RC_GTEST_PROP(corner_resolver, a_chain_of_lines_is_the_polygon_through_its_corners, ()) {
  std::vector<Motion> chain, plain;
  Vec2 at;
  double degrees = 0;
  const auto count = *rc::gen::inRange(3, 7);
  for (int i = 0; i < count; ++i) {
    const double line_length = number(40, 60), rounding = i + 1 < count && *rc::gen::arbitrary<bool>() ? number(0.5, 4) : 0;
    const Vec2 direction = rotated({1, 0}, degrees), beyond = at + number(1, 200) * direction;
    at = at + line_length * direction;
    plain.push_back(compensated(line(at, 0, rounding)));
    const bool last = i + 1 == count;
    chain.push_back(i == 0 ? compensated(line(beyond, 0, rounding)) : over_line(last ? at : beyond, degrees, rounding));
    degrees += (*rc::gen::arbitrary<bool>() ? 1 : -1) * number(20, 120);
  }
  const Outcome expected = carried(plain, 4), found = carried(chain, static_cast<std::size_t>(*rc::gen::inRange(1, 9)));
  RC_ASSERT(!expected.fault);
  RC_ASSERT(!found.fault);
  RC_ASSERT(expected.motions.size() == found.motions.size());
  for (std::size_t i = 0; i < expected.motions.size(); ++i) {
    RC_ASSERT(length(end_of(expected.motions[i]) - end_of(found.motions[i])) < near);
    RC_ASSERT(expected.motions[i].kind == found.motions[i].kind);
  }
  RC_ASSERT(std::fabs(length_of(expected.motions) - length_of(found.motions)) < near * 100);
}

TEST(corner_resolver, what_no_corner_concerns_passes) {
  CornerResolver corners{ToolPosition{}};
  ActionBatch batch;
  batch.add() = test::action(line({10, 0}));
  batch.add().what = Dwell{1};
  batch.add() = test::action(compensated(line({20, 0})));
  batch.add() = test::action(line({20, 10}));
  EXPECT_FALSE(corners.take(batch, Follows::more));
  ASSERT_EQ(batch.size(), 4U);
  EXPECT_EQ(std::get<Motion>(batch[3].what).to[1], 10);
}

TEST(corner_resolver, the_last_motion_with_compensation_waits_for_the_next_batch) {
  CornerResolver corners{ToolPosition{}};
  ActionBatch batch;
  batch.add() = test::action(compensated(line({10, 0})));
  batch.add() = test::action(compensated(line({20, 0})));
  batch.add().what = Dwell{1};
  EXPECT_FALSE(corners.take(batch, Follows::more));
  EXPECT_EQ(batch.size(), 1U);
  batch.clear();
  EXPECT_FALSE(corners.take(batch, Follows::nothing));
  EXPECT_EQ(batch.size(), 2U);
}

TEST(corner_resolver, other_actions_come_behind_the_chamfer) {
  CornerResolver corners{ToolPosition{}};
  ActionBatch batch;
  batch.add() = test::action(line({10, 0}, 2));
  batch.add().what = Dwell{1};
  batch.add() = test::action(line({10, 10}));
  EXPECT_FALSE(corners.take(batch, Follows::more));
  ASSERT_EQ(batch.size(), 4U);
  EXPECT_EQ(std::get<Motion>(batch[0].what).to[0], 8);
  EXPECT_EQ(std::get<Motion>(batch[1].what).to[1], 2);
  EXPECT_TRUE(std::holds_alternative<Dwell>(batch[2].what));
}

TEST(corner_resolver, nothing_follows) {
  EXPECT_EQ(carried({line({10, 0}), line({20, 0}, 2)}).fault->alarm.id, AlarmId::corner_illegal);
  const Outcome o = carried({line({10, 0}), line({20, 0}, 2)}, 5);
  EXPECT_EQ(o.motions.size(), 1U);
  EXPECT_EQ(o.fault->origin.line, 2U);
  const Outcome alarmed = carried({line({10, 0}), line({20, 0}, 2)}, 1, Follows::alarm);  // the alarm has another cause
  EXPECT_FALSE(alarmed.fault);
  EXPECT_EQ(alarmed.motions.back().to[0], 20);
}

TEST(corner_resolver, too_many_actions_between) {
  CornerResolver corners{ToolPosition{}};
  ActionBatch batch;
  batch.add() = test::action(line({10, 0}, 2));
  for (int i = 0; i < 100; ++i) batch.add().what = Dwell{1};
  const auto fault = corners.take(batch, Follows::more);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->alarm.id, AlarmId::corner_illegal);
  CornerResolver plain{ToolPosition{}};  // if only a calculated end could follow, the motion is passed on as programmed
  batch.clear();
  batch.add() = test::action(compensated(line({10, 0})));
  for (int i = 0; i < 100; ++i) batch.add().what = Dwell{1};
  EXPECT_FALSE(plain.take(batch, Follows::more));
  EXPECT_EQ(batch.size(), 101U);
}

TEST(corner_resolver, what_empties_the_buffer_breaks_the_corner) {
  for (const Action& between :
       {Action{{}, FrameChange{}}, Action{{}, Stop{false}}, Action{{}, CompensationBreak{}}, Action{{}, ZoneChange{}}}) {
    CornerResolver corners{ToolPosition{}};
    ActionBatch batch;
    batch.add() = test::action(line({10, 0}, 2));
    batch.add() = between;
    batch.add() = test::action(line({10, 10}));
    EXPECT_EQ(corners.take(batch, Follows::more)->alarm.id, AlarmId::corner_illegal);
  }
}

TEST(corner_resolver, a_cut_beyond_an_end_that_is_found_later) {
  // R10 at the first corner removes 10 mm from the second line; the third line leaves only 5 mm of it.
  const std::vector<Motion> contour{compensated(line({50, 0}, 0, 10)), over_line({50, 40}, 90), over_line({90, 5}, 0)};
  const Outcome o = carried(contour, 1);
  ASSERT_TRUE(o.fault);
  EXPECT_EQ(o.fault->alarm.id, AlarmId::corner_too_large);
  EXPECT_EQ(o.fault->origin.line, 1U);
  EXPECT_TRUE(o.motions.empty());
}

TEST(corner_resolver, both_corners_of_a_line_must_fit) {
  const Outcome o = carried({line({50, 0}, 5), line({50, 10}, 6), line({0, 10})});
  EXPECT_EQ(o.fault->alarm.id, AlarmId::corner_too_large);
  EXPECT_EQ(o.fault->origin.line, 2U);
  EXPECT_EQ(o.motions.size(), 2U);  // the first corner is cut
  const Outcome fits = carried({line({50, 0}, 5), line({50, 10}, 5), line({0, 10})});
  EXPECT_FALSE(fits.fault);
  EXPECT_EQ(fits.motions.size(), 4U);  // nothing of the second line remains
}

TEST(corner_resolver, machine_coordinates_turn_with_the_frame) {
  auto rotation = std::make_shared<FrameTurn>();
  rotation->rows = {Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}};
  ToolPosition start;
  start.turn = rotation;
  CornerResolver corners{start};
  ActionBatch batch;
  Motion first = line({10, 0}, 2), second = line({10, 10});
  first.machine = {0, 10, 0};
  second.machine = {-10, 10, 0};
  batch.add() = test::action(first);
  batch.add() = test::action(second);
  EXPECT_FALSE(corners.take(batch, Follows::nothing));
  ASSERT_EQ(batch.size(), 3U);
  EXPECT_EQ(std::get<Motion>(batch[0].what).machine, (Axes{0, 8, 0}));
  EXPECT_EQ(std::get<Motion>(batch[1].what).machine, (Axes{-2, 10, 0}));
}

TEST(corner_resolver, an_axis_that_follows_goes_with_the_corner) {
  Motion first = line({10, 0}, 2), second = line({10, 10});
  auto detail = std::make_shared<MotionDetail>(*first.detail);
  detail->followers = {{3, 0, -1}};
  first.detail = std::move(detail);
  first.to[3] = first.machine[3] = second.to[3] = second.machine[3] = -10;
  const Outcome o = carried({first, second}, 2);
  ASSERT_FALSE(o.fault);
  EXPECT_EQ(o.motions[0].to[3], -8);
  EXPECT_EQ(o.motions[1].machine[3], -10);
  EXPECT_EQ(o.motions[1].detail->followers.size(), 1U);
}

TEST(corner_resolver, the_way_in_belongs_to_the_motion_that_begins) {
  Motion first = compensated(line({10, 0}, 2)), second = compensated(line({10, 10}));
  first.side_step = SideStep::begins;
  first.tool_radius = 3;
  const Outcome o = carried({first, second}, 2);
  ASSERT_EQ(o.motions.size(), 3U);
  EXPECT_EQ(o.motions[0].side_step, SideStep::begins);
  EXPECT_EQ(o.motions[1].side_step, SideStep::none);
  EXPECT_EQ(o.motions[1].tool_radius, 3);
}

TEST(corner_resolver, spirals_and_other_planes_have_no_corner) {
  Motion spiral = test::arc(MotionKind::arc_ccw, {0, 20, 0}, {0, 10, 0}, 0.5);
  spiral.center = {0, 12};
  EXPECT_EQ(carried({line({-10, 0}), line({0, 0}, 2), spiral}).fault->alarm.id, AlarmId::corner_illegal);
  Motion inclined = line({10, 10});
  inclined.to[2] = 1;
  EXPECT_EQ(carried({line({10, 0}, 2), inclined}).fault->alarm.id, AlarmId::corner_illegal);
  Motion other = line({10, 10});
  other.first = 2;
  other.second = 0;
  EXPECT_EQ(carried({line({10, 0}, 2), other}).fault->alarm.id, AlarmId::corner_illegal);
}

TEST(corner_resolver, an_over_determined_block_needs_an_element_before) {
  EXPECT_EQ(carried({over_line({10, 10}, 45)}).fault->alarm.id, AlarmId::contour_no_intersection);
  const Motion rapid = compensated(test::straight(MotionKind::rapid, {20, 0, 0}));
  EXPECT_EQ(carried({rapid, over_line({10, 10}, 45)}).fault->origin.line, 2U);
  EXPECT_EQ(carried({compensated(line({10, 0})), over_line({10, 10}, 0)}).fault->origin.line, 1U);  // the lines are parallel
}

}  // namespace
}  // namespace kadr::corner_resolver_test
