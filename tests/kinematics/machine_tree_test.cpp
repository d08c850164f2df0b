// kinematics/machine_tree: the chains of a machine file, forward and inverse, compared with the formulas of NCT 25.1.

#include "kinematics/machine_tree.h"

#include <gtest/gtest.h>

#include <random>

namespace kadr::machine_tree_test {
namespace {

using Names = std::vector<std::string>;

AxisProfile linear(Vec3 along, bool reversed = false) {
  AxisProfile axis;
  axis.joint = {false, along, {}, reversed, false};
  return axis;
}

AxisProfile rotary(Vec3 about, Vec3 through, bool reversed = false, double least = -1e300, double most = 1e300) {
  AxisProfile axis;
  axis.joint = {true, unit(about), through, reversed, false};
  axis.least = least;
  axis.most = most;
  return axis;
}

MachineProfile machine(Names tool, Names part) {
  MachineProfile m;
  m.axes = {{"X", linear({1, 0, 0})}, {"Y", linear({0, 1, 0})}, {"Z", linear({0, 0, 1})}};
  m.chains.tool = std::move(tool);
  m.chains.part = std::move(part);
  return m;
}

Axes anywhere(std::mt19937& random) {
  Axes at{};
  std::uniform_real_distribution<double> places(-300, 300), turns(-170, 170);
  for (std::size_t i = 0; i < 3; ++i) at[i] = places(random);
  for (std::size_t i = 3; i < 6; ++i) at[i] = turns(random);
  return at;
}

void expect_near(Vec3 a, Vec3 b, double bound) { EXPECT_LT(length(a - b), bound) << a.x << ' ' << a.y << ' ' << a.z; }

/// Checks forward, inverse and forward again: the tool must be at the same position, and the axis positions within the limits.
void moves_backwards(const MachineTree& tree, int times, double nearby) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> deviation(-nearby, nearby);
  for (int i = 0; i < times; ++i) {
    const Axes at = anywhere(random);
    Axes near = at;
    for (double& axis : near) axis += deviation(random);
    const Pose pose = tree.forward(at, 80);
    const auto back = tree.inverse(pose, near, 80);
    ASSERT_TRUE(back) << i;
    const Pose again = tree.forward(*back, 80);
    expect_near(again.tip, pose.tip, 1e-6);
    expect_near(again.direction, pose.direction, 1e-8);
  }
}

TEST(machine_tree, built_in_machines_there_and_back) {
  for (const char* id : {"table-table", "head-head", "head-table"}) {
    const auto profile = load_machine(id);
    ASSERT_TRUE(profile) << profile.error();
    MachineProfile free = *profile;  // another test covers the limits
    for (auto& [name, axis] : free.axes) axis.least = -1e300, axis.most = 1e300;
    moves_backwards(MachineTree(free, {"X", "Y", "Z", "A", "B", "C"}), 2000, 180);
  }
}

// The standard machine types computed by the formulas of the NCT: both descriptions give the same positions and directions.
TEST(machine_tree, the_same_as_the_parameters_of_the_nct) {
  const Vec3 one{20, -30, -400}, other{25, -26, -460};
  struct Kind {
    Names tool, part;
    MachineGroup group;
  };
  const Kind kinds[] = {{{"X", "Y", "Z", "C", "A"}, {}, MachineGroup::head_head},
                        {{"Z"}, {"X", "Y", "C", "A"}, MachineGroup::table_table},
                        {{"Y", "Z", "C"}, {"X", "A"}, MachineGroup::head_table}};
  for (const Kind& kind : kinds)
    for (const bool reversed : {false, true}) {
      MachineProfile m = machine(kind.tool, kind.part);
      m.axes["C"] = rotary({0, 1, 1}, one, reversed);
      m.axes["A"] = rotary({1, 0, 0}, other);
      const MachineTree tree(m, {"X", "Y", "Z", "A", "C"});
      const auto five = tree.five_axis();
      ASSERT_TRUE(five) << five.error();
      EXPECT_EQ(five->group, kind.group);
      EXPECT_EQ(five->first.axis, 4);
      EXPECT_EQ(five->second.axis, 3);
      std::mt19937 random(3);
      for (int i = 0; i < 500; ++i) {
        const Axes at = anywhere(random);
        const RotaryPair pair{at[4], at[3]};
        const Vec3 control_point{at[0], at[1], at[2]};
        const Pose pose = tree.forward(at, 75);
        expect_near(pose.direction, five->direction(pair), 1e-12);
        expect_near(pose.tip, five->point_in_part(pair, control_point - five->length_vector(pair, {0, 0, 75})), 1e-9);
      }
    }
}

// A quill after the head, three rotary axes, a slanted slide: none of them can be described by the parameters of the NCT.
TEST(machine_tree, any_serial_chain) {
  MachineProfile quill = machine({"X", "Y", "C", "A", "Z"}, {});
  quill.axes["C"] = rotary({0, 0, 1}, {0, 0, 100});
  quill.axes["A"] = rotary({1, 0, 0}, {0, 40, 100});
  const MachineTree with_quill(quill, {"X", "Y", "Z", "A", "B", "C"});
  EXPECT_EQ(with_quill.five_axis().error(), "axis Z turns with a rotary axis");
  const Axes leaning{0, 0, -50, 90, 0, 0};
  expect_near(with_quill.forward(leaning, 0).tip, {0, 190, 60}, 1e-9);

  MachineProfile six = machine({"X", "Z", "B", "A"}, {"Y", "C"});
  six.axes["A"] = rotary({1, 0, 0}, {0, 0, 60});
  six.axes["B"] = rotary({0, 1, 0}, {0, 0, 160});
  six.axes["C"] = rotary({0, 0, 1}, {-300, -300, -500}, true);
  const MachineTree redundant(six, {"X", "Y", "Z", "A", "B", "C"});
  EXPECT_EQ(redundant.five_axis().error(), "it has not two rotary axes");
  moves_backwards(redundant, 500, 60);

  MachineProfile slanted = machine({"X", "Y", "Z"}, {"A"});
  slanted.axes["Y"] = linear(unit({0, 1, 1}), true);
  slanted.axes["A"] = rotary({1, 0, 0}, {0, 0, -200});
  const MachineTree lathe(slanted, {"X", "Y", "Z", "A"});
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {  // one rotary axis: only directions that it can reach
    const Axes at = anywhere(random);
    Axes near = at;
    near[3] += 20;
    const auto back = lathe.inverse(lathe.forward(at, 30), near, 30);
    ASSERT_TRUE(back);
    expect_near(lathe.forward(*back, 30).tip, lathe.forward(at, 30).tip, 1e-6);
  }
  EXPECT_FALSE(lathe.inverse({{}, {1, 0, 0}}, {}, 30)) << "a direction that no position gives";
}

TEST(machine_tree, limits_choose_and_refuse) {
  MachineProfile m = machine({"X", "Y", "Z", "C", "A"}, {});
  m.axes["C"] = rotary({0, 0, 1}, {}, false, -200, 200);
  m.axes["A"] = rotary({1, 0, 0}, {}, false, -10, 90);
  const MachineTree tree(m, {"X", "Y", "Z", "A", "C"});
  const Vec3 leaning = unit({0, 1, 1});
  const auto at = tree.inverse({{}, leaning}, {}, 0);
  ASSERT_TRUE(at);
  EXPECT_NEAR((*at)[3], 45, 1e-9);
  EXPECT_NEAR(std::fabs((*at)[4]), 180, 1e-9);
  EXPECT_FALSE(tree.inverse({{}, {0, 0, -1}}, {}, 0));
  m.axes["Z"].least = -1;
  m.axes["Z"].most = 1;
  EXPECT_FALSE(MachineTree(m, {"X", "Y", "Z", "A", "C"}).inverse({{0, 0, 50}, {0, 0, 1}}, {}, 0));
}

}  // namespace
}  // namespace kadr::machine_tree_test
