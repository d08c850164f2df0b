// machine/virtual_machine: axis limits, and the position after changes of the frame.

#include "machine/virtual_machine.h"

#include <gtest/gtest.h>

#include "actions.h"

namespace kadr::virtual_machine_test {
namespace {

using test::action;
using test::arc;
using test::straight;
using enum MotionKind;

const std::vector<std::string> names = {"X", "Y", "Z"};

VirtualMachine machine(const Setup& setup = {}, const ToolPosition& start = {}) {
  MachineProfile profile;
  profile.axes["X"] = {10000, -100, 100};
  return {names, 0, profile, setup, start};
}

TEST(virtual_machine, limit_of_the_profile) {
  VirtualMachine m = machine();
  EXPECT_TRUE(m.take(action(straight(rapid, {100, 0, 0}))));
  const Status refused = m.take(action(straight(rapid, {100.5, 5, 0})));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().id, AlarmId::limit_exceeded);
  EXPECT_EQ(refused.error().args[0].text(), "X");
  EXPECT_EQ(refused.error().args[1].number(), 100.5);
  EXPECT_EQ(refused.error().args[2].number(), 100);
  EXPECT_EQ(m.position().work[1], 0);  // nothing has moved
}

TEST(virtual_machine, the_setup_goes_before_the_profile) {
  kadr::Setup setup;
  setup.machine["X"].limits = {{-5, 5}};
  setup.machine["*"].limits = {{-50, 50}};
  VirtualMachine m = machine(setup);
  EXPECT_FALSE(m.take(action(straight(rapid, {6, 0, 0}))));
  EXPECT_FALSE(m.take(action(straight(rapid, {0, 51, 0}))));
  EXPECT_TRUE(m.take(action(straight(rapid, {5, 50, 0}))));
}

TEST(virtual_machine, the_top_of_an_arc_counts) {
  VirtualMachine m = machine({}, {{95, 0, 0}, {95, 0, 0}});
  const Status refused = m.take(action(arc(arc_ccw, {95, 20, 0}, {95, 10, 0}, 0.5)));
  ASSERT_FALSE(refused);
  EXPECT_DOUBLE_EQ(refused.error().args[1].number(), 105);
  EXPECT_TRUE(m.take(action(arc(arc_cw, {95, 20, 0}, {95, 10, 0}, 0.5))));
}

TEST(virtual_machine, from_outside_an_axis_may_come_in) {
  VirtualMachine m = machine({}, {{150, 0, 0}, {150, 0, 0}});
  EXPECT_TRUE(m.take(action(straight(rapid, {150, 10, 0}))));
  EXPECT_TRUE(m.take(action(straight(rapid, {120, 10, 0}))));
  EXPECT_FALSE(m.take(action(straight(rapid, {121, 10, 0}))));
}

TEST(virtual_machine, probe_switch_stops_the_motion) {
  kadr::Setup setup;
  setup.probe[1] = AxisValues{{"X", 80}};
  setup.probe[2] = std::nullopt;
  const VirtualMachine m = machine(setup);
  Motion motion = straight(probe, {100, 50, 0}, 60);
  motion.machine = {110, 50, 0};
  const ProbeAnswer answer = m.probe(motion);
  EXPECT_TRUE(answer.touched);
  EXPECT_EQ(answer.at, (Axes{80, 40, 0}));
  end_at(motion, answer);
  EXPECT_EQ(motion.machine, (Axes{90, 40, 0}));
  EXPECT_FALSE(m.probe(straight(probe, {79, 0, 0})).touched);
  EXPECT_EQ(m.probe(straight(probe, {79, 0, 0})).at, (Axes{79, 0, 0}));
}

TEST(virtual_machine, an_arc_in_a_turned_frame_counts_in_machine_axes) {  // nct 10.2.3
  FrameTurn quarter;                                                      // about Y: X becomes -Z, Z becomes X
  quarter.rows = {Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{-1, 0, 0}};
  VirtualMachine m = machine({}, {{0, 0, 95}, {95, 0, 0}, std::make_shared<FrameTurn>(quarter)});
  Motion up = arc(arc_ccw, {0, 0, 95}, {0, 0, 89}, 1, Plane::zx);
  up.machine = {95, 0, 0};
  EXPECT_TRUE(m.take(action(up)));
  up.center.x = 101;  // in Z: up to 107
  const Status refused = m.take(action(up));
  ASSERT_FALSE(refused);
  EXPECT_NEAR(refused.error().args[1].number(), 107, 1e-9);
}

TEST(virtual_machine, polar_interpolation_may_pass_a_limit_between_its_ends) {
  const std::vector<std::string> axes = {"X", "C"};
  kadr::Setup setup;
  setup.machine["X"].limits = {{5, 100}};
  VirtualMachine m(axes, 2, MachineProfile{}, setup, {{50, 0}, {50, 0}});
  MotionDetail detail;
  detail.surface = PathSurface::polar;
  detail.flat_from = {50, 1};
  detail.flat_to = {-50, 1};
  Motion past = straight(feed, {50, 177.7, 0}, 100);
  past.detail = std::make_shared<MotionDetail>(detail);
  const Status refused = m.take(action(past));
  ASSERT_FALSE(refused);
  EXPECT_NEAR(refused.error().args[1].number(), 1, 1e-9);
}

TEST(virtual_machine, probe_motion_ends_in_a_turned_frame) {
  FrameTurn quarter;  // about Z, from X towards Y
  quarter.rows = {Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}};
  Motion motion = straight(probe, {100, 0, 0}, 60);
  motion.machine = {5, 107, 3};
  end_at(motion, {true, {80, 0, 0}}, &quarter);
  EXPECT_EQ(motion.machine, (Axes{5, 87, 3}));
}

Motion with_input(Motion motion, int input) {
  MotionDetail detail;
  detail.input = input;
  motion.detail = std::make_shared<MotionDetail>(detail);
  return motion;
}

TEST(virtual_machine, a_probe_motion_looks_at_its_input) {  // nct 21.1
  kadr::Setup setup;
  setup.probe[1] = AxisValues{{"X", 30}};
  setup.probe[3] = AxisValues{{"X", 20}};
  const VirtualMachine m = machine(setup);
  const Motion motion = straight(probe, {80, 0, 0}, 60);
  EXPECT_EQ(m.probe(with_input(motion, 1)).at[0], 30);
  EXPECT_EQ(m.probe(with_input(motion, 3)).at[0], 20);
  EXPECT_EQ(m.probe(motion).at[0], 20);
  EXPECT_DOUBLE_EQ(m.probe(motion).part, 0.25);
  for (const int silent : {2, 98}) {
    EXPECT_FALSE(m.probe(with_input(motion, silent)).touched);
    EXPECT_EQ(m.probe(with_input(motion, silent)).at[0], 80);
  }
}

TEST(virtual_machine, a_probe_motion_of_an_axis_that_rolls_over) {  // nct 5.6, 21.1
  kadr::Setup setup;
  setup.probe[1] = AxisValues{{"C", 370}};
  VirtualMachine m({"X", "C"}, 2, MachineProfile{}, setup, {{0, 350}, {0, 350}});
  Motion motion = with_input(straight(probe, {0, 30, 0}, 60), 1);
  MotionDetail detail = *motion.detail;
  detail.rolled = 2;
  detail.travel[1] = 40;
  motion.detail = std::make_shared<MotionDetail>(detail);
  Action turn = action(motion);
  bool touched = false;
  EXPECT_TRUE(m.execute(turn, [&](const ProbeAnswer& answer) { touched = answer.touched; }));
  EXPECT_TRUE(touched);
  EXPECT_EQ(std::get<Motion>(turn.what).to[1], 370);
  EXPECT_DOUBLE_EQ(std::get<Motion>(turn.what).machine[1], 370);
  EXPECT_DOUBLE_EQ(std::get<Motion>(turn.what).detail->travel[1], 20);
}

TEST(virtual_machine, with_cbm_the_whole_way_of_a_probe_must_be_free) {  // nct 22.4
  kadr::Setup setup;
  setup.probe[1] = AxisValues{{"X", 30}};
  setup.machine["X"].limits = {{0, 50}};
  Action motion = action(with_input(straight(probe, {80, 0, 0}, 60), 1));
  int answers = 0;
  const auto count = [&](const ProbeAnswer&) { ++answers; };
  VirtualMachine free = machine(setup);
  free.obey_parameters(setup);
  EXPECT_TRUE(free.execute(motion, count));
  EXPECT_EQ(answers, 1);
  setup.parameters[{"1001", "", "CBM"}] = 1.0;
  VirtualMachine checked = machine(setup);
  checked.obey_parameters(setup);
  motion = action(with_input(straight(probe, {80, 0, 0}, 60), 1));
  const Status refused = checked.execute(motion, count);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().id, AlarmId::zone1_positive);
  EXPECT_EQ(answers, 1);
}

TEST(virtual_machine, axes_that_do_not_come_into_position) {  // nct 4.1.1
  kadr::Setup setup;
  setup.machine["X"].position_error = 0.1;
  setup.machine["Y"].position_error = -0.01;
  setup.parameters[{"0516", "", ""}] = 0.01;
  VirtualMachine m = machine(setup);
  m.obey_parameters(setup);
  EXPECT_TRUE(m.has_limits());
  Motion x = straight(rapid, {10, 0, 0}), y = straight(rapid, {10, 10, 0}), back = straight(feed, {0, 0, 0}, 100);
  EXPECT_TRUE(m.take(action(x)));
  EXPECT_TRUE(m.in_position());  // not requested
  y.in_position = back.in_position = true;
  EXPECT_TRUE(m.take(action(y)));
  EXPECT_TRUE(m.in_position());  // X does not move, and Y is close enough
  EXPECT_TRUE(m.take(action(back)));
  ASSERT_FALSE(m.in_position());
  EXPECT_EQ(m.in_position().error().id, AlarmId::position_error);
  EXPECT_EQ(m.in_position().error().args[0].text(), "X");
  Action pause{};
  pause.what = Dwell{1};
  EXPECT_TRUE(m.take(pause));
  EXPECT_TRUE(m.in_position());
}

VirtualMachine::Outcome taken(VirtualMachine& m, std::initializer_list<Action> actions, ActionBatch& batch,
                              VirtualMachine::Follows follows = VirtualMachine::Follows::more) {
  batch.clear();
  for (const Action& a : actions) batch.add() = a;
  return m.take(batch, follows, [](const ProbeAnswer&) {});
}

TEST(virtual_machine, a_refused_batch_leaves_nothing) {
  VirtualMachine m = machine();
  ActionBatch batch;
  const auto outcome = taken(m, {action(straight(rapid, {10, 0, 0}), 4), action(straight(rapid, {101, 0, 0}), 5)}, batch);
  EXPECT_TRUE(outcome.refused);
  EXPECT_EQ(outcome.done, 0U);
  EXPECT_EQ(outcome.origin.line, 5U);
  EXPECT_EQ(m.position().work[0], 0);
}

TEST(virtual_machine, motions_held_back_of_blocks_before_stay_done) {  // nct 4.7
  VirtualMachine m = machine();
  ActionBatch batch;
  Motion little = straight(feed, {0.005, 0, 0}, 100);
  little.join = 0.01;
  EXPECT_FALSE(taken(m, {action(little, 1)}, batch).alarm);
  EXPECT_TRUE(batch.empty());
  const auto outcome = taken(m, {action(straight(rapid, {101, 0, 0}), 2)}, batch);
  EXPECT_TRUE(outcome.refused);
  EXPECT_EQ(outcome.done, 1U);
  EXPECT_EQ(batch[0].origin.line, 1U);
  EXPECT_EQ(m.position().work[0], 0.005);
}

TEST(virtual_machine, a_motion_held_back_may_itself_be_refused) {
  VirtualMachine m = machine({}, {{99.998, 0, 0}, {99.998, 0, 0}});
  ActionBatch batch;
  Motion little = straight(feed, {100.005, 0, 0}, 100);
  little.join = 0.01;
  EXPECT_FALSE(taken(m, {action(little, 1)}, batch).alarm);
  const auto outcome = taken(m, {}, batch, VirtualMachine::Follows::nothing);
  EXPECT_TRUE(outcome.refused);
  EXPECT_EQ(outcome.done, 0U);
  EXPECT_EQ(outcome.origin.line, 1U);
  EXPECT_EQ(m.position().work[0], 99.998);
}

TEST(virtual_machine, a_motion_out_of_position_is_done_and_nothing_behind_it) {
  kadr::Setup setup;
  setup.machine["Y"].position_error = 1;
  VirtualMachine m = machine(setup);
  m.obey_parameters(setup);
  ActionBatch batch;
  Motion y = straight(rapid, {0, 10, 0});
  y.in_position = true;
  const auto outcome = taken(m, {action(y, 1), action(straight(rapid, {5, 10, 0}), 1)}, batch);
  EXPECT_FALSE(outcome.refused);
  EXPECT_EQ(outcome.done, 1U);
  EXPECT_EQ(outcome.alarm->id, AlarmId::position_error);
  EXPECT_EQ(m.position().work, (Axes{0, 10, 0}));
}

}  // namespace
}  // namespace kadr::virtual_machine_test
