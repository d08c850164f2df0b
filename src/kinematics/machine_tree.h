#pragma once
// MachineTree: a machine as its file describes it: from the bed a chain of axes to the tool and one to the part, linear and rotary in any
// order and number ([kinematics] of machines/*.toml). Where the tool is in the part, and the axes for a place and a direction. What
// NCT 25.1 can say of such a machine is a FiveAxis. mm, degrees; positions are those of the machine.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "action/placement.h"
#include "config/machine_profile.h"
#include "kinematics/five_axis.h"

namespace kadr {

struct MachineJoint {
  std::string name;
  int axis = -1;  // by index in the channel; -1: the channel has it not, it stands at 0
  AxisJoint moves;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

class MachineTree {
 public:
  /// `axes`: names of the channel, in their order.
  MachineTree(const MachineProfile& profile, const std::vector<std::string>& axes);

  bool empty() const { return tool_.empty() && part_.empty(); }
  const std::vector<MachineJoint>& tool() const { return tool_; }
  const std::vector<MachineJoint>& part() const { return part_; }

  /// Where the tool is in the part, seen from the part as it lies where all axes stand at 0, whose zero is that of the machine.
  ///   tool_length  from the tip to the gauge point
  Pose forward(const Axes& axes, double tool_length) const;
  /// The positions at which the tool is there; of several the one nearest to `near`, within the limits. Axes that are not needed stay.
  ///   law      forward(*inverse(pose, near, l), l) == pose
  ///   returns  nothing: not to be reached
  std::optional<Axes> inverse(const Pose& pose, const Axes& near, double tool_length) const;

  /// The machine in the terms of NCT 25.1.
  ///   returns  a sentence: why it is none of that kind
  tl::expected<FiveAxis, std::string> five_axis() const;

 private:
  static double position(const MachineJoint& joint, const Axes& axes);
  Vec3 direction(const Axes& axes) const { return forward(axes, 0).direction; }
  bool turn_to(Vec3 wanted, Axes& axes) const;
  bool turn_by_steps(Vec3 wanted, Axes& axes) const;
  bool move_to(Vec3 tip, Axes& axes, double tool_length) const;
  std::vector<const MachineJoint*> joints(bool rotary) const;
  FiveAxis directions(const std::vector<const MachineJoint*>& rotary) const;

  std::vector<MachineJoint> tool_, part_;  // from the bed
  Vec3 tool_direction_;
};

}  // namespace kadr
