// path/compensation/queued_compensation: corners keep their distance, the state can be copied, and actions keep their order. LinuxCNC 7.5.
// How LinuxCNC's interpreter itself compensates programs: tests/golden/linuxcnc, tests/cases/linuxcnc/compensation.cases.

#include "path/compensation/queued_compensation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "contours.h"

namespace kadr::queued_compensation_test {
namespace {

using test::any_number;
using test::Contour;

using Follows = QueuedCompensation::Follows;

Action action_of(const Motion& m, std::uint32_t line = 0) {
  Action action;
  action.origin.line = line;
  action.what = m;
  return action;
}

Action action_of(decltype(Action::what) what) {
  Action action;
  action.what = std::move(what);
  return action;
}

/// Feeds the actions one at a time. With `snapshot`, a fresh object receives
/// each action and continues from the memory of the previous object.
struct Taken {
  std::vector<Action> actions;
  std::optional<CompensationFault> fault;
};
Taken taken(const std::vector<Action>& actions, bool snapshot) {
  Taken all;
  auto now = std::make_unique<QueuedCompensation>(ToolPosition{});
  for (const Action& action : actions) {
    ActionBatch batch;
    batch.add() = action;
    if (snapshot) {
      auto fresh = std::make_unique<QueuedCompensation>(ToolPosition{});
      fresh->resume_from(now->memory());
      now = std::move(fresh);
    }
    all.fault = now->take(batch, Follows::more);
    all.actions.insert(all.actions.end(), batch.begin(), batch.end());
    if (all.fault) break;
  }
  return all;
}

const Motion& motion_in_action(const Action& action) { return std::get<Motion>(action.what); }

RC_GTEST_PROP(queued_corner, of_two_lines_keeps_the_radius, ()) {
  const double radius = any_number(1, 9), side = *rc::gen::element(1.0, -1.0), turn = any_number(-170, 170);
  const CornerSituation place{{40, 30}, Vec2{40, 30} + radius * side_normal({1, 0}, side), radius, side};
  const Vec2 along = rotated({1, 0}, turn);
  const auto corner = corner_to_line(place, place.point + 50 * along);
  RC_ASSERT(corner.has_value());
  RC_ASSERT(length(corner->end - (place.point + 50 * along + radius * side_normal(along, side))) < 1e-9);
  const double outside = -side * turn * rad_per_deg;  // the gap on the tool's side
  RC_ASSERT((corner->kind == CornerKind::outer) == (outside > 0.05));
  RC_ASSERT((corner->kind == CornerKind::inner) == (outside < -0.05));
  if (corner->kind == CornerKind::outer) RC_ASSERT(std::fabs(length(corner->at - place.point) - radius) < 1e-9);
  if (corner->kind != CornerKind::inner) return;
  for (const Vec2 direction : {Vec2{1, 0}, along}) RC_ASSERT(std::fabs(side * cross(direction, corner->at - place.point) - radius) < 1e-6);
}

RC_GTEST_PROP(queued_corner, inside_with_arcs_is_beside_both, ()) {
  const double radius = any_number(1, 4), side = *rc::gen::element(1.0, -1.0), turn = side * any_number(20, 80);
  const bool first_arc = *rc::gen::arbitrary<bool>();
  const int sense = *rc::gen::element(1, -1);
  Contour c;
  if (first_arc) c.arc(any_number(30, 60), 0.1 * *rc::gen::element(1, -1), 1, radius);
  else c.line(50, 1, radius);
  const Motion before = c.motions.back();
  const Vec2 tool = c.at + radius * side_normal(c.direction, side);
  CornerSituation place{c.at, tool, radius, side};
  if (first_arc) place.arc = QueuedArc{tool, before.center, before.kind == MotionKind::arc_ccw ? 1 : -1};
  const Vec2 end_direction = c.direction;
  c.direction = rotated(c.direction, turn);
  c.arc(any_number(30, 60), 0.1 * sense, 1, radius);
  const Motion& next = c.motions.back();
  const auto corner = corner_to_arc(place, {c.at, next.center, sense});
  RC_ASSERT(corner.has_value());
  RC_ASSERT(corner->kind == CornerKind::inner);
  const double of_next = length(place.point - next.center) - side * sense * radius;
  RC_ASSERT(std::fabs(length(corner->at - next.center) - of_next) < 1e-6);
  if (first_arc) RC_ASSERT(std::fabs(length(corner->at - before.center) - length(tool - before.center)) < 1e-6);
  else RC_ASSERT(std::fabs(side * cross(end_direction, corner->at - place.point) - radius) < 1e-6);
}

RC_GTEST_PROP(queued_corner, entry_arc_is_one, ()) {
  const double radius = any_number(1, 5), side = *rc::gen::element(1.0, -1.0);
  const int sense = *rc::gen::element(1, -1);
  Contour c;
  c.arc(any_number(20, 60), sense * any_number(1, 3) / 10, 1, radius);
  const Motion& m = c.motions.back();
  const auto entry = entry_arc({}, {c.at, m.center, sense}, radius, side);
  RC_ASSERT(entry.has_value());
  RC_ASSERT(std::fabs(length(entry->end - c.at) - radius) < 1e-9);
  RC_ASSERT(std::fabs(length(entry->center) - length(entry->end - entry->center)) < 1e-6);
  RC_ASSERT(std::fabs(cross(entry->end - c.at, m.center - c.at)) < 1e-6);
}

RC_GTEST_PROP(queued_compensation, what_it_remembers_is_a_value, ()) {
  const auto side = *rc::gen::element<std::int8_t>(1, -1);
  const double radius = any_number(1, 5);
  Contour c;
  c.line(20, side, radius).side_step = SideStep::begins;
  std::vector<Action> actions{action_of(c.motions.back(), 1)};
  const int count = *rc::gen::inRange(1, 8);
  for (int i = 0; i < count; ++i) {
    c.direction = rotated(c.direction, any_number(-170, 170));
    if (*rc::gen::arbitrary<bool>()) c.line(any_number(1, 60), side, radius);
    else c.arc(any_number(2, 60), any_number(-800, 800) / 1000, side, radius);
    actions.push_back(action_of(c.motions.back(), static_cast<std::uint32_t>(i) + 2));
    if (*rc::gen::inRange(0, 4) == 0) actions.push_back(action_of(Dwell{1}));
    if (*rc::gen::inRange(0, 6) == 0) actions.push_back(action_of(CompensationBreak{}));
  }
  actions.push_back(action_of(CompensationBreak{true}));
  const Taken plain = taken(actions, false), again = taken(actions, true);
  RC_ASSERT(plain.fault.has_value() == again.fault.has_value());
  if (plain.fault) RC_ASSERT(plain.fault->origin.line == again.fault->origin.line);
  RC_ASSERT(plain.actions.size() == again.actions.size());
  for (std::size_t i = 0; i < plain.actions.size(); ++i)
    if (const auto* const m = std::get_if<Motion>(&plain.actions[i].what)) RC_ASSERT(m->to == motion_in_action(again.actions[i]).to);
}

/// The path of a turning tool's tip is the centre's path shifted as a
/// whole by the radius along one axis or both; the alarms are the same.
RC_GTEST_PROP(queued_compensation, a_tip_goes_beside_the_centre, ()) {
  const auto side = *rc::gen::element<std::int8_t>(1, -1);
  const double radius = any_number(1, 3);
  Contour c;
  c.line(20, side, radius).side_step = SideStep::begins;
  for (int i = *rc::gen::inRange(1, 8); i > 0; --i) {
    c.direction = rotated(c.direction, any_number(-60, 60));
    if (*rc::gen::arbitrary<bool>()) c.line(any_number(10, 60), side, radius);
    else c.arc(any_number(5, 60), any_number(-300, 300) / 1000, side, radius);
  }
  std::vector<Action> of_centre, of_tip;
  const auto nose = static_cast<std::uint8_t>(*rc::gen::inRange(1, 9));
  for (Motion& m : c.motions) {
    of_centre.push_back(action_of(m));
    m.nose = nose;
    of_tip.push_back(action_of(m));
  }
  of_centre.push_back(action_of(CompensationBreak{true}));
  of_tip.push_back(action_of(CompensationBreak{true}));
  const Taken centre = taken(of_centre, false), tip = taken(of_tip, true);
  RC_ASSERT(centre.fault.has_value() == tip.fault.has_value());
  RC_ASSERT(centre.actions.size() == tip.actions.size());
  std::optional<Vec2> shift;
  for (std::size_t i = 0; i < centre.actions.size(); ++i) {
    const auto* const a = std::get_if<Motion>(&centre.actions[i].what);
    if (a == nullptr) continue;
    const Motion& b = motion_in_action(tip.actions[i]);
    const Vec2 now{b.to[0] - a->to[0], b.to[1] - a->to[1]};
    if (!shift) shift = now;
    RC_ASSERT(length(now - *shift) < 1e-9);
    for (const double part : {now.x, now.y}) RC_ASSERT(std::fabs(part) < 1e-9 || std::fabs(std::fabs(part) - radius) < 1e-9);
    if (is_arc(a->kind)) RC_ASSERT(length(b.center - a->center - now) < 1e-9 && std::fabs(a->turns - b.turns) < 1e-6);
  }
  if (shift) RC_ASSERT(length(*shift) > radius / 2);
}

TEST(queued_compensation, without_a_side_nothing_changes) {
  Contour c;
  c.line(20, 0, 0);
  c.arc(10, 0.25, 0, 0);
  const Taken all = taken({action_of(c.motions[0]), action_of(Dwell{1}), action_of(c.motions[1])}, false);
  ASSERT_EQ(all.actions.size(), 3U);
  EXPECT_EQ(motion_in_action(all.actions[2]).to, c.motions[1].to);
}

/// Messages and tool selections come out at once. A dwell comes after the motion that it follows, before the corner.
TEST(queued_compensation, order) {
  Contour c;
  c.line(20, 1, 5).side_step = SideStep::begins;
  c.line(50, 1, 5);
  c.direction = {0, -1};
  c.line(50, 1, 5);
  const Taken all = taken({action_of(c.motions[0]), action_of(c.motions[1]), action_of(Dwell{1}), action_of(Message{"hi"}),
                           action_of(c.motions[2]), action_of(CompensationBreak{true})},
                          false);
  ASSERT_EQ(all.actions.size(), 6U);
  EXPECT_EQ(motion_in_action(all.actions[0]).to[1], 5);
  EXPECT_TRUE(std::holds_alternative<Message>(all.actions[1].what));
  EXPECT_EQ(motion_in_action(all.actions[2]).to[0], 70);
  EXPECT_TRUE(std::holds_alternative<Dwell>(all.actions[3].what));
  EXPECT_EQ(motion_in_action(all.actions[4]).kind, MotionKind::arc_cw);
  EXPECT_NEAR(motion_in_action(all.actions[5]).to[0], 75, 1e-9);
}

/// The alarm is reported at the block that is being read, and the motion that cannot be built is not executed.
TEST(queued_compensation, line_too_short_for_its_corners) {
  Contour c;
  c.line(20, 1, 5).side_step = SideStep::begins;
  c.line(40, 1, 5);
  c.direction = {0, 1};
  c.line(4, 1, 5);
  c.direction = {-1, 0};
  c.line(40, 1, 5);
  std::vector<Action> actions;
  for (std::size_t i = 0; i < c.motions.size(); ++i) actions.push_back(action_of(c.motions[i], static_cast<std::uint32_t>(i) + 1));
  const Taken all = taken(actions, false);
  ASSERT_TRUE(all.fault);
  EXPECT_EQ(all.fault->alarm.id, AlarmId::gouge_feed);
  EXPECT_EQ(all.fault->origin.line, 4U);
  EXPECT_EQ(all.actions.size(), 2U);
}

/// A neck narrower than the tool, with a wider space after it. The control
/// compares neighbouring blocks only, so a warning reports the neck.
TEST(queued_compensation, narrow_neck_is_warned_of) {
  Contour c;
  c.line(20, -1, 5).side_step = SideStep::begins;
  const auto go = [&](Vec2 direction, double length) {
    c.direction = direction;
    c.line(length, -1, 5);
  };
  go({1, 0}, 20);
  go({0, 1}, 30);
  go({-1, 0}, 20);
  go({0, 1}, 30);
  go({1, 0}, 46);
  go({0, -1}, 30);
  go({-1, 0}, 20);
  go({0, -1}, 30);
  go({1, 0}, 40);
  QueuedCompensation compensation{ToolPosition{}};
  ActionBatch batch;
  for (const Motion& m : c.motions) batch.add() = action_of(m);
  batch.add() = action_of(CompensationBreak{true});
  EXPECT_FALSE(compensation.take(batch, Follows::more));
  ASSERT_EQ(compensation.warnings().size(), 1U);
  EXPECT_EQ(compensation.warnings()[0].alarm.id, AlarmId::contour_cut);
}

TEST(queued_compensation, too_many_actions_between) {
  Contour c;
  c.line(20, 1, 5).side_step = SideStep::begins;
  QueuedCompensation compensation{ToolPosition{}};
  ActionBatch batch;
  batch.add() = action_of(c.motions[0]);
  for (int i = 0; i < 5000; ++i) batch.add() = action_of(Dwell{1});
  const auto fault = compensation.take(batch, Follows::more);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->alarm.id, AlarmId::compensation_buffer);
}

}  // namespace
}  // namespace kadr::queued_compensation_test
