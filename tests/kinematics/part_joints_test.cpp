// kinematics/part_joints: the joints that a page receives put the part back onto the machine, so that the tool is where it really is.

#include "kinematics/part_joints.h"

#include <gtest/gtest.h>

#include <random>

namespace kadr::part_joints_test {
namespace {

/// Returns J1(a1) · J2(a2) · … · place.
Vec3 carried(const std::vector<PartJoint>& joints, Vec3 place, const std::vector<double>& positions) {
  for (std::size_t i = joints.size(); i-- > 0;) {
    const PartJoint& j = joints[i];
    place = j.turns ? j.through + Mat3::about(j.direction, positions[i]) * (place - j.through) : place + positions[i] * j.direction;
  }
  return place;
}

Vec3 carried_back(const std::vector<PartJoint>& joints, Vec3 place, const std::vector<double>& positions) {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const PartJoint& j = joints[i];
    place = j.turns ? j.through + Mat3::about(j.direction, -positions[i]) * (place - j.through) : place - positions[i] * j.direction;
  }
  return place;
}

/// Returns the position on the machine of a point of the drawn part.
Vec3 on_machine(const std::vector<PartJoint>& joints, Vec3 place, const Axes& axes) {
  std::vector<double> now, from;
  for (const PartJoint& j : joints) now.push_back(axes[std::size_t(j.axis)]), from.push_back(j.from);
  return carried(joints, carried_back(joints, place, from), now);
}

AxisProfile axis(bool turns, Vec3 direction, Vec3 through, bool reversed) {
  AxisProfile made;
  made.joint = {turns, unit(direction), through, reversed, false};
  return made;
}

/// The position of the tool tip seen from the bed, without the axes that come before the first joint that turns the part.
TEST(part_joints, of_a_tree_put_the_tip_back) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> mm(-300, 300), degrees(-170, 170);
  const std::vector<std::string> names = {"X", "Y", "Z", "A", "C"};
  const std::vector<std::vector<std::string>> parts = {{"A", "C"}, {"X", "A", "C"}, {"X", "Y", "C"}, {"A", "Y", "C"}, {"C"}, {"X", "Y"}};
  for (int i = 0; i < 600; ++i) {
    MachineProfile machine;
    const auto any = [&] { return Vec3{mm(random), mm(random), mm(random)}; };
    const auto flag = [&] { return random() % 2 == 0; };
    machine.axes = {{"X", axis(false, {1, 0, 0}, {}, flag())},
                    {"Y", axis(false, {0, 1, 0}, {}, flag())},
                    {"Z", axis(false, {0, 0, 1}, {}, flag())},
                    {"A", axis(true, {1, 0, 0}, any(), flag())},
                    {"C", axis(true, {0, 0, 1}, any(), flag())}};
    machine.chains.part = parts[std::size_t(i) % parts.size()];
    for (const std::string& name : names)
      if (std::find(machine.chains.part.begin(), machine.chains.part.end(), name) == machine.chains.part.end())
        machine.chains.tool.push_back(name);
    const MachineTree tree(machine, names);
    const Axes axes{mm(random), mm(random), mm(random), degrees(random), degrees(random)};
    MachineProfile headless = machine;  // the same, but the part is not rotated, and what carries its first joint does not move
    auto& chain = headless.chains.part;
    const auto first = std::find_if(chain.begin(), chain.end(), [&](const std::string& name) { return machine.axes.at(name).joint.turns; });
    chain.erase(first, chain.end());
    const Vec3 seen = on_machine(part_joints(tree), tree.forward(axes, 80).tip, axes);
    ASSERT_LT(length(seen - MachineTree(headless, names).forward(axes, 80).tip), 1e-9) << i;
  }
}

/// The tip of an upright tool is at the position of the main axes.
TEST(part_joints, of_a_part_space_put_the_tip_back) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> mm(-300, 300), degrees(-170, 170);
  for (int i = 0; i < 400; ++i) {
    const auto any = [&] { return Vec3{mm(random), mm(random), mm(random)}; };
    FiveAxisTransformData d;
    d.machine.group = i % 2 == 0 ? MachineGroup::table_table : MachineGroup::head_table;
    d.machine.first = {3, {1, 0, 0}, random() % 2 == 0 ? 1.0 : -1.0};
    d.machine.second = {4, {0, 0, 1}, random() % 2 == 0 ? 1.0 : -1.0};
    d.machine.table = any();
    if (i % 2 == 0) d.machine.second_table = any();
    d.zero = any();
    d.measured = {i % 2 == 0 ? degrees(random) : 0, degrees(random)};
    d.length = {0, 0, 50};
    const FiveAxisTransform space(d);
    Axes axes{mm(random), mm(random), mm(random), degrees(random), degrees(random)};
    if (i % 2 != 0) axes[3] = 0;
    const Vec3 seen = on_machine(part_joints(d), space.pose(axes).tip + d.zero, axes);
    ASSERT_LT(length(seen - Vec3{axes[0], axes[1], axes[2] - 50}), 1e-9) << i;
  }
}

}  // namespace
}  // namespace kadr::part_joints_test
