// kinematics/five_axis_transform: transforms between work coordinates, part and machine in each state of spec/nct/25a 6.3.

#include "kinematics/five_axis_transform.h"

#include <gtest/gtest.h>

#include <random>

namespace kadr::five_axis_transform_test {
namespace {

/// Returns any machine in any state with random numbers.
FiveAxisTransformData any_data(std::mt19937& random) {
  std::uniform_real_distribution<double> angle(-180, 180), mm(-300, 300);
  const auto vector = [&] { return Vec3{mm(random), mm(random), mm(random)}; };
  const auto turn = [&] { return Mat3::about({1, 0, 0}, angle(random)) * Mat3::about({0, 0, 1}, angle(random)); };
  const auto flag = [&] { return random() % 2 == 0; };
  FiveAxisTransformData d;
  d.machine.group = static_cast<MachineGroup>(1 + random() % 3);
  d.machine.first = {3, {0, 0, 1}, flag() ? 1. : -1.};
  d.machine.second = {4, flag() ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, flag() ? 1. : -1.};
  d.machine.table = vector();
  if (d.machine.group == MachineGroup::table_table) d.machine.second_table = vector();
  d.machine.holder = vector();
  d.zero = vector();
  d.basic = turn();
  d.has_frame = flag();
  if (d.has_frame) d.frame = turn(), d.frame_origin = vector(), d.shift = vector();
  d.length = mm(random) * d.machine.tool;
  d.follows_table = d.machine.has_table() && flag();
  d.moves_origin = d.machine.has_table() && !d.follows_table && flag();
  d.follows_head = d.machine.has_head() && flag();
  d.controls_tip = d.follows_table && flag();
  if (!d.controls_tip && flag()) d.fixed = RotaryPair{angle(random), angle(random)};
  return d;
}

TEST(five_axis_transform, work_of_machine_is_the_same) {
  std::mt19937 random(251);
  std::uniform_real_distribution<double> angle(-180, 180), mm(-300, 300);
  for (int i = 0; i < 20'000; ++i) {
    const FiveAxisTransform space(any_data(random));
    const Axes work{mm(random), mm(random), mm(random), angle(random), angle(random)};
    const Axes machine = space.machine_of(work, work);
    const Axes back = space.work_of(machine, machine);
    for (std::size_t a = 0; a < 5; ++a) ASSERT_NEAR(back[a], work[a], 1e-8) << i << " axis " << a;
  }
}

/// If the control follows all axes, the tool is really where the program puts it.
TEST(five_axis_transform, a_led_tip_is_where_it_is_programmed) {
  std::mt19937 random(252);
  std::uniform_real_distribution<double> angle(-180, 180), mm(-300, 300);
  for (int i = 0; i < 5'000; ++i) {
    FiveAxisTransformData d = any_data(random);
    d.fixed.reset();
    d.moves_origin = false;
    d.controls_tip = true;
    d.follows_table = d.machine.has_table();
    d.follows_head = d.machine.has_head();
    const FiveAxisTransform space(d);
    const Axes work{mm(random), mm(random), mm(random), angle(random), angle(random)};
    const Vec3 tip = space.pose(space.machine_of(work, work)).tip, wanted = space.in_system(Vec3{work[0], work[1], work[2]});
    ASSERT_NEAR(length(tip - wanted), 0, 1e-8);
    EXPECT_FALSE(space.is_plain());
  }
}

/// A basic rotation about the tool's own axis turns the free axis by the same angle (25l, golden 25-70).
TEST(five_axis_transform, the_basic_rotation_tilts_the_tool) {
  FiveAxisTransformData d;
  d.machine.group = MachineGroup::head_head;
  d.machine.first = {3, {0, 0, 1}, 1};
  d.machine.second = {4, {1, 0, 0}, 1};
  d.basic = Mat3::about({0, 0, 1}, 10);
  d.follows_head = d.corrects = true;
  const FiveAxisTransform space(d);
  const Axes machine = space.machine_of({0, 0, 0, 60, 30}, {0, 0, 0, 60, 30});
  EXPECT_NEAR(machine[3], 70, 1e-9);
  EXPECT_NEAR(machine[4], 30, 1e-9);
}

TEST(five_axis_transform, rotary_axes_alone_move_what_follows_them) {
  FiveAxisTransformData d;
  d.machine.group = MachineGroup::head_head;
  d.machine.first = {3, {0, 0, 1}, 1};
  d.machine.second = {4, {1, 0, 0}, 1};
  EXPECT_EQ(FiveAxisTransform(d).moved_with(0b01000), 0b01000U);
  d.follows_head = true;
  EXPECT_EQ(FiveAxisTransform(d).moved_with(0b01000), 0b01111U);
  EXPECT_EQ(FiveAxisTransform(d).moved_with(0b00001), 0b00001U);
  d.keeps_linear = true;  // N3212 FOS
  EXPECT_EQ(FiveAxisTransform(d).moved_with(0b01000), 0b01000U);
  EXPECT_TRUE(FiveAxisTransform(d).changes_work(0b01000));
  EXPECT_EQ(FiveAxisTransform(d).moved_with(0b01001), 0b01111U);
  d.has_frame = true;
  EXPECT_EQ(FiveAxisTransform(d).moved_with(0b00001), 0b00111U);
}

}  // namespace
}  // namespace kadr::five_axis_transform_test
