#pragma once
// The joints that turn the part, in order from the bed to the part. A picture needs them to show the part as it lies on the machine.
// mm, degrees.

#include <vector>

#include "kinematics/machine_tree.h"
#include "kinematics/part_space.h"

namespace kadr {

struct PartJoint {
  int axis = -1;  // index in the channel, never -1
  bool turns = true;
  Vec3 direction;   // unit length: for a positive motion of the axis the part turns right-handed about it, or moves along it …
  Vec3 through;     // … through this point; both with all axes at 0, in machine coordinates
  double from = 0;  // position of the axis at which the part lies as drawn
};

/// Returns the joints from the first rotary axis on; linear axes nearer to the bed move the part and the tool's origin alike and are
/// left out. The result is empty if nothing turns the part.
///   law  seen from the first joint's carrier, a point of the part is at J1(a1) · J2(a2) · … · (J1(from1) · J2(from2) · …)⁻¹ · place
std::vector<PartJoint> part_joints(const MachineTree& tree);
std::vector<PartJoint> part_joints(const PartSpaceData& data);

}  // namespace kadr
