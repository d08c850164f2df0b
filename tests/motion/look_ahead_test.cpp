// motion/look_ahead/look_ahead: the actions come out in the order in which they went in, with the times of nct 4.1, 6 and 7.

#include "motion/look_ahead/look_ahead.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "actions.h"
#include "kinematics/five_axis_transform.h"
#include "motion/time/steps.h"

namespace kadr::look_ahead_test {
namespace {

using test::arc;
using test::straight;
using enum MotionKind;

const std::vector<std::string> names = {"X", "Y", "Z"};
const AxisRoles roles = AxisRoles::of(names, 0);

struct Timed {
  Action action;
  MotionTime time;
};

/// Sends a program through the estimate of the programmed times, and then through the look-ahead.
std::vector<Timed> run(const std::vector<Action>& program, const SpeedRules& rules) {
  kadr::Setup setup;
  setup.machine["*"].rapid = 6000;
  const Rates rates = rates_of(MachineProfile{}, setup, names);
  TimeEstimate estimate(roles, rates);
  std::vector<Timed> out;
  ToolPosition at;  // the position after the actions that have come out
  LookAhead look_ahead(roles, rules, rates.rapid, [&](const Step& step, double longer) {
    out.push_back({step.action, step.time});
    EXPECT_EQ(step.from.work, at.work) << "it is handed on with where the tool stood";
    at.take(step.action);
    if (const Motion* const m = step.motion()) estimate.lengthen(*m, longer);
  });
  Steps steps(roles, {}, &estimate);
  for (const Action& a : program) steps.give(a, [&](const Step& step) { look_ahead.consume(step); });
  look_ahead.finish();
  double sum = 0;
  for (const Timed& t : out) sum += t.time.seconds;
  EXPECT_NEAR(estimate.split().cutting + estimate.split().rapid, sum, 1e-9 * (1 + sum));  // it does not count pauses
  return out;
}

double seconds(const std::vector<Timed>& all) {
  double sum = 0;
  for (const Timed& t : all) sum += t.time.seconds;
  return sum;
}

SpeedRules linear(double acceleration) {
  SpeedRules rules;
  rules.stated = 7;
  rules.acceleration = axes_filled(acceleration);
  return rules;
}

Motion exact(Motion m) {
  m.exact = m.in_position = true;
  return m;
}

Action act(const Motion& m) { return test::action(m); }

double within(double low, double high) { return low + (high - low) * *rc::gen::resize(100, rc::gen::inRange(0, 1'000'001)) / 1e6; }

std::vector<Action> any_lines() {
  std::vector<Action> program;
  const int count = *rc::gen::inRange(1, 40);
  for (int i = 0; i < count; ++i) {
    const Motion m = straight(feed, {within(-20, 20), within(-20, 20), within(-5, 5)}, within(100, 6000));
    program.push_back(test::action(m, static_cast<std::uint32_t>(i)));
    if (*rc::gen::inRange(0, 10) == 0) program.push_back({{}, FrameChange{{}, m.to}});
    if (*rc::gen::inRange(0, 10) == 0) program.push_back({{}, Dwell{0.5}});
  }
  return program;
}

SpeedRules any_rules() {
  SpeedRules rules = linear(within(100, 3000));
  rules.by_axis_change = *rc::gen::arbitrary<bool>();
  rules.axis_change = axes_filled(within(1, 50));
  rules.corner_angle = within(0, 90);
  rules.corner_feed = within(1, 50);
  rules.normal = axes_filled(within(10, 1000));
  rules.line_step = axes_filled(within(10, 1000));
  if (*rc::gen::arbitrary<bool>()) rules.build_up = axes_filled(0.05);
  return rules;
}

/// NCT 25.14: the tip moves 10 mm while the head, 100 mm above the tip, tilts by 90°. X moves by up to 1 + 100·(π/2)/10 mm per mm of
/// the tip. From rest to rest this takes 2·√(L·u/A).
TEST(look_ahead, the_axes_limit_a_tip_that_is_led) {
  FiveAxisTransformData d;
  d.machine.group = MachineGroup::head_head;
  d.machine.first = {3, {0, 1, 0}, 1};
  d.machine.second = {4, {1, 0, 0}, 1};
  d.length = {0, 0, 100};
  d.controls_tip = d.follows_head = true;
  const AxisRoles five = AxisRoles::of({"X", "Y", "Z", "B", "A"}, 0b11000);
  ToolPosition from;
  from.space = std::make_shared<const FiveAxisTransform>(d);
  from.machine = from.space->machine_of(from.work, from.work);
  Motion motion = straight(feed, {10, 0, 0}, 1e6);
  motion.to[3] = 90;
  motion.machine = from.space->machine_of(motion.to, motion.to);
  const auto seconds_of = [&](const ToolPosition& at, const SpeedRules& rules) {
    double sum = 0;
    LookAhead look_ahead(five, rules, {}, [&](const Step& step, double) { sum += step.time.seconds; });
    const Action action = act(motion);
    MotionTime time;
    time.seconds = 10 / (1e6 / 60);
    look_ahead.consume(Step(five, action, at, 0, time));
    look_ahead.finish();
    return sum;
  };
  const double u = 1 + 100 * std::numbers::pi / 2 / 10;
  EXPECT_NEAR(seconds_of(from, linear(1000)), 2 * std::sqrt(10 * u / 1000), 0.01);
  SpeedRules slow = linear(1e9);
  slow.max_feed = axes_filled(50);  // mm/s, for each axis
  EXPECT_NEAR(seconds_of(from, slow), 10 / (50 / u), 0.05);
}

RC_GTEST_PROP(look_ahead, hands_on_each_action_once_in_order, ()) {
  const std::vector<Action> program = any_lines();
  const std::vector<Timed> out = run(program, any_rules());
  RC_ASSERT(out.size() == program.size());
  for (std::size_t i = 0; i < out.size(); ++i) RC_ASSERT(out[i].action.what.index() == program[i].what.index());
  for (std::size_t i = 0; i < out.size(); ++i) RC_ASSERT(out[i].action.origin.line == program[i].origin.line);
}

RC_GTEST_PROP(look_ahead, no_axis_changes_its_feed_more_than_it_may, ()) {
  SpeedRules rules = any_rules();
  rules.by_axis_change = true;
  double before_feed = 0;
  Axes at{}, before{};
  for (const Timed& t : run(any_lines(), rules)) {
    const auto* const m = std::get_if<Motion>(&t.action.what);
    if (m == nullptr) continue;
    RC_ASSERT(t.time.feed_most <= m->feed * (1 + 1e-9));
    Axes travel{};
    for (std::size_t i = 0; i < 3; ++i) travel[i] = (m->to[i] - at[i]) / t.time.length;
    for (std::size_t i = 0; i < 3; ++i) RC_ASSERT(std::abs(travel[i] - before[i]) * before_feed / 60 <= rules.axis_change[i] * (1 + 1e-9));
    before_feed = *t.time.feed_end;
    before = travel;
    at = m->to;
  }
}

RC_GTEST_PROP(look_ahead, backwards_it_takes_the_same_time, ()) {
  SpeedRules rules = any_rules();
  rules.build_up = {};
  std::vector<Vec3> points = {{0, 0, 0}};
  std::vector<double> feeds;
  for (int i = *rc::gen::inRange(1, 30); i > 0; --i) {
    points.push_back({within(-20, 20), within(-20, 20), within(-5, 5)});
    feeds.push_back(within(100, 6000));
  }
  std::vector<Action> there = {act(straight(rapid, points.front()))}, back = {act(straight(rapid, points.back()))};
  for (std::size_t i = 0; i < feeds.size(); ++i) {
    there.push_back(act(straight(feed, points[i + 1], feeds[i])));
    back.push_back(act(straight(feed, points[feeds.size() - 1 - i], feeds[feeds.size() - 1 - i])));
  }
  const double one = seconds(run(there, rules)), other = seconds(run(back, rules));
  const double seconds_there = run({back.front()}, rules)[0].time.seconds;
  RC_ASSERT(std::abs(one - (other - seconds_there)) < 1e-9 * (1 + one));
}

/// The curvature of short lines (N0402, N0403) depends on their lengths, so both are switched off.
RC_GTEST_PROP(look_ahead, a_line_cut_in_two_takes_the_same_time, ()) {
  SpeedRules rules = any_rules();
  rules.build_up = {};
  rules.normal = rules.line_step = axes_filled(unlimited);
  std::vector<Action> program;
  Axes at{};
  const int count = *rc::gen::inRange(1, 30), cut = *rc::gen::inRange(0, count);
  for (int i = 0; i < count; ++i)
    program.push_back(act(straight(feed, {within(-20, 20), within(-20, 20), within(-5, 5)}, within(100, 6000))));
  const double whole = seconds(run(program, rules));
  const auto place = program.begin() + cut;
  if (cut > 0) at = std::get<Motion>((place - 1)->what).to;
  Motion first = std::get<Motion>(place->what);
  const double part = within(0.01, 0.99);
  for (std::size_t i = 0; i < 3; ++i) first.to[i] = at[i] + part * (first.to[i] - at[i]);
  program.insert(place, act(first));
  RC_ASSERT(std::abs(seconds(run(program, rules)) - whole) < 1e-9 * (1 + whole));
}

/// More motions than the window can hold give the speed of an unlimited window, because the machine can stop within the newer half.
TEST(look_ahead, goes_on_past_its_window) {
  std::vector<Action> program;
  for (int i = 1; i <= 20'000; ++i) program.push_back(act(straight(feed, {0.1 * i, 0, 0}, 6000)));
  SpeedRules rules = linear(1000);
  EXPECT_NEAR(seconds(run(program, rules)), 0.1 + 2000 / 100.0, 1e-7);  // F/a + L/F
  rules.build_up = axes_filled(0.05);
  EXPECT_NEAR(seconds(run(program, rules)), 0.15 + 2000 / 100.0, 1e-7);
}

TEST(look_ahead, stops_for_functions_and_exact_stop) {
  const std::vector<Action> line = {act(straight(feed, {50, 0, 0}, 6000)), act(straight(feed, {100, 0, 0}, 6000))};
  EXPECT_NEAR(seconds(run(line, linear(1000))), 1.1, 1e-12);
  EXPECT_NEAR(seconds(run({line[0], {{}, MachineFunction{30}}, line[1]}, linear(1000))), 1.2, 1e-12);
  EXPECT_NEAR(seconds(run({line[0], {{}, FrameChange{{}, {50, 0, 0}}}, line[1]}, linear(1000))), 1.1, 1e-12);
  EXPECT_NEAR(seconds(run({act(exact(straight(feed, {50, 0, 0}, 6000))), line[1]}, linear(1000))), 1.2, 1e-12);
}

TEST(look_ahead, rapid_motions_from_rest_to_rest) {
  const std::vector<Action> program = {act(straight(rapid, {100, 50, 0})), act(straight(rapid, {100, 50, 100}))};
  const std::vector<Timed> out = run(program, linear(1000));
  EXPECT_NEAR(out[0].time.seconds, 1.1, 1e-12);  // X limits: 100 mm/s, 1000 mm/s²
  EXPECT_NEAR(out[0].time.feed_most, 6000 * std::sqrt(1.25), 1e-8);
  EXPECT_NEAR(out[1].time.seconds, 1.1, 1e-12);
}

TEST(look_ahead, rapid_motions_overlap) {
  SpeedRules rules = linear(1000);
  rules.overlaps_rapids = true;
  rules.overlap_from = 0.25;
  const Action up = act(straight(rapid, {0, 0, 100})), over = act(straight(rapid, {100, 0, 100}));
  EXPECT_NEAR(run({up, over}, rules)[0].time.seconds, 1.1 - 0.075, 1e-9);  // three quarters of its 0.1 s remain
  EXPECT_NEAR(run({up, over}, rules)[1].time.seconds, 1.1, 1e-12);
  EXPECT_NEAR(run({act(exact(straight(rapid, {0, 0, 100}))), over}, rules)[0].time.seconds, 1.1, 1e-12);
  EXPECT_NEAR(run({up, act(straight(rapid, {100, 0, 0}))}, rules)[0].time.seconds, 1.1, 1e-12);  // Z moves in both motions
  EXPECT_NEAR(run({up, act(straight(feed, {100, 0, 100}, 600))}, rules)[0].time.seconds, 1.1, 1e-12);
}

/// A circle of radius 10 mm as chords: the speed is that on the circle, √(a·r).
TEST(look_ahead, short_lines_have_the_curvature_of_their_circle) {
  std::vector<Action> program = {act(straight(rapid, {10, 0, 0}))};
  for (int i = 1; i <= 360; ++i) {
    const SinCos at = sincos_deg(i);
    program.push_back(act(straight(feed, {10 * at.cos, 10 * at.sin, 0}, 6000)));
  }
  SpeedRules rules = linear(unlimited);
  rules.normal = axes_filled(250);
  const std::vector<Timed> out = run(program, rules);
  const double per_axis = 3000 / std::sqrt(std::cos(rad_per_deg * 0.5) * std::cos(rad_per_deg * 0.5));
  EXPECT_NEAR(*out[180].time.feed_end, per_axis, 1);  // where the path is parallel to an axis: one axis has the whole normal acceleration
  rules.normal = axes_filled(unlimited);
  rules.line_step = axes_filled(250);
  EXPECT_NEAR(*run(program, rules)[1].time.feed_end, 3000, 30);  // the acceleration jumps from zero to F²/r
}

TEST(look_ahead, inner_arcs_and_corners_are_slower) {
  SpeedRules rules = linear(unlimited);
  rules.slows_inner_arcs = true;
  Motion inner = arc(arc_ccw, {0, 4, 0}, {0, 0, 0}, 0.25);
  inner.feed = 600;
  inner.side = 1;
  inner.tool_radius = 6;
  const Action to_start = act(straight(rapid, {4, 0, 0}));
  EXPECT_NEAR(run({to_start, act(inner)}, rules)[1].time.feed_most, 240, 1e-9);
  inner.side = -1;
  EXPECT_NEAR(run({to_start, act(inner)}, rules)[1].time.feed_most, 600, 1e-9);

  rules.inner_angle = 100;
  rules.inner_part = 0.5;
  rules.inner_before = 10;
  rules.inner_after = 20;
  Motion in = straight(feed, {60, 0, 0}, 600), out = straight(feed, {60, 60, 0}, 600);
  in.side = out.side = 1;
  in.tool_radius = out.tool_radius = 6;
  in.corner_speed = out.corner_speed = CornerSpeed::inner_slower;
  const std::vector<Timed> left = run({act(in), act(out)}, rules);
  EXPECT_NEAR(left[0].time.seconds, 5 + 2, 1e-9);  // 50 mm, and 10 mm at half the feed
  EXPECT_NEAR(left[1].time.seconds, 4 + 4, 1e-9);  // 20 mm at half the feed, 40 mm at the full feed
  in.side = out.side = -1;
  EXPECT_NEAR(run({act(in), act(out)}, rules)[0].time.seconds, 6, 1e-9);
}

TEST(look_ahead, threads_keep_their_time) {
  Motion thread_cut = straight(thread, {0, 0, -10});
  MotionDetail detail;
  detail.lead = 1;
  thread_cut.detail = std::make_shared<const MotionDetail>(detail);
  std::vector<MotionTime> out;
  LookAhead look_ahead(roles, linear(1000), {}, [&](const Step& step, double) { out.push_back(step.time); });
  MotionTime programmed;
  programmed.seconds = 3;
  const Action cut = act(thread_cut);
  const ToolPosition start;
  look_ahead.consume(Step(roles, cut, start, 0, programmed));
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(out[0].seconds, 3);
}

}  // namespace
}  // namespace kadr::look_ahead_test
