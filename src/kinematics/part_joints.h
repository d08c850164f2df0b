#pragma once
// Lists the joints (axes) that move the part, in order from the bed to the part. Drawings use the joints to show the part in its
// orientation on the machine. Units: mm, degrees.

#include <vector>

#include "kinematics/five_axis_transform.h"
#include "kinematics/machine_tree.h"

namespace kadr {

struct PartJoint {
  int axis = -1;  // index of the axis in the channel; part_joints() leaves out axes that the channel lacks, so it never returns -1
  bool turns = true;
  Vec3 direction;   // unit vector: a positive motion rotates the part right-handed about it, or moves the part along it
  Vec3 through;     // a point on the axis of rotation; like `direction`, in machine coordinates with all axes at 0
  double from = 0;  // axis position at which the drawing shows the part
};

/// Returns the joints from the rotary axis nearest to the bed onwards. Linear axes between the bed and this rotary axis are left out, since
/// they move the part and the tool's origin alike. The result is empty if no rotary axis moves the part.
///   law  seen from the link that carries the first joint, a point of the part is at
///        J1(a1) · J2(a2) · … · (J1(from1) · J2(from2) · …)⁻¹ · place, where Ji(a) is the motion of joint i to the axis position a
std::vector<PartJoint> part_joints(const MachineTree& tree);
std::vector<PartJoint> part_joints(const FiveAxisTransformData& data);

}  // namespace kadr
