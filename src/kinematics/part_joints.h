#pragma once
// Joints that turn the part, from the bed to the part: what a picture needs to show a part as it stands on the machine. mm, degrees.

#include <vector>

#include "kinematics/machine_tree.h"
#include "kinematics/part_space.h"

namespace kadr {

struct PartJoint {
  int axis = -1;  // by index in the channel, never -1
  bool turns = true;
  Vec3 direction;   // of length 1: the part turns right-handed about it, or goes along it, as the axis goes in its positive direction …
  Vec3 through;     // … through this point: both where all axes stand at 0, machine coordinates
  double from = 0;  // position at which the part lies as it is drawn
};

/// From the first axis that turns on; what moves the part and the tool's zero alike below it is left out. Empty: nothing turns the part.
///   law  a place of the part is, seen from what carries the first joint, at J1(a1) · J2(a2) · … · (J1(from1) · J2(from2) · …)⁻¹ · place
std::vector<PartJoint> part_joints(const MachineTree& tree);
std::vector<PartJoint> part_joints(const PartSpaceData& data);

}  // namespace kadr
