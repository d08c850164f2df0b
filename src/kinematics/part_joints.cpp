// Lists the joints that move the part. Used by view/path_record; tested by tests/kinematics/part_joints_test.cpp.

#include "kinematics/part_joints.h"

namespace kadr {

/// The `direction` of a linear joint in the machine file is the direction in which the tool moves as seen from the part (AxisJoint). The
/// result has the opposite direction, in which the part moves.
std::vector<PartJoint> part_joints(const MachineTree& tree) {
  std::vector<PartJoint> joints;
  for (const MachineJoint& joint : tree.part()) {
    if (joint.axis < 0 || (joints.empty() && !joint.moves.turns)) continue;
    const double sense = joint.moves.reversed == joint.moves.turns ? -1 : 1;
    joints.push_back({joint.axis, joint.moves.turns, sense * joint.moves.direction, joint.moves.through});
  }
  return joints;
}

std::vector<PartJoint> part_joints(const FiveAxisTransformData& data) {
  const FiveAxis& machine = data.machine;
  std::vector<PartJoint> joints;
  const auto add = [&](const RotaryJoint& joint, Vec3 through, double from) {
    if (joint.axis >= 0) joints.push_back({joint.axis, true, joint.sense * joint.direction, through, from});
  };
  if (machine.first_on_table()) add(machine.first, machine.table, data.measured.first);
  const Vec3 second = machine.first_on_table() ? machine.table + machine.second_table : machine.table;
  if (machine.second_on_table()) add(machine.second, second, data.measured.second);
  return joints;
}

}  // namespace kadr
