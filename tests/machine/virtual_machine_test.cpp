// machine/virtual_machine: axis limits, and the position after frame changes.

#include "machine/virtual_machine.h"

#include <gtest/gtest.h>

#include "actions.h"

namespace kadr {
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
  FrameRotation quarter;                                                  // about Y: X becomes -Z, Z becomes X
  quarter.rows = {Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{-1, 0, 0}};
  VirtualMachine m = machine({}, {{0, 0, 95}, {95, 0, 0}, std::make_shared<FrameRotation>(quarter)});
  Motion up = arc(arc_ccw, {0, 0, 95}, {0, 0, 89}, 1, Plane::zx);
  up.machine = {95, 0, 0};
  EXPECT_TRUE(m.take(action(up)));
  up.center.x = 101;  // of Z: up to 107
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
  FrameRotation quarter;  // about Z: X towards Y
  quarter.rows = {Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}};
  Motion motion = straight(probe, {100, 0, 0}, 60);
  motion.machine = {5, 107, 3};
  end_at(motion, {true, {80, 0, 0}}, &quarter);
  EXPECT_EQ(motion.machine, (Axes{5, 87, 3}));
}

}  // namespace
}  // namespace kadr
