#pragma once
// MachineTree: a machine as its file describes it ([kinematics] of machines/*.toml). Two chains of linear and rotary axes, in any order and
// number, lead from the bed to the tool and from the bed to the part. The class computes the tool's pose relative to the part, and the axis
// positions for a pose. A machine that fits NCT 25.1 converts to a FiveAxis. Units: mm, degrees; positions are machine positions.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "action/placement.h"
#include "config/machine/machine_profile.h"
#include "kinematics/five_axis.h"

namespace kadr {

struct MachineJoint {
  std::string name;
  int axis = -1;  // index of the axis in the channel; -1: the channel lacks the axis, whose position is then always 0
  AxisJoint moves;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

class MachineTree {
 public:
  /// Builds the chains of the profile. `axes` lists the channel's axis names in order.
  MachineTree(const MachineProfile& profile, const std::vector<std::string>& axes);

  bool empty() const { return tool_.empty() && part_.empty(); }
  const std::vector<MachineJoint>& tool() const { return tool_; }
  const std::vector<MachineJoint>& part() const { return part_; }

  /// Returns the pose of the tool in coordinates that are fixed to the part, and that equal machine coordinates when all axes are at 0.
  ///   tool_length  distance from the tip to the gauge point, mm
  Pose forward(const Axes& axes, double tool_length) const;
  /// Returns axis positions within the limits that give the pose; if there are several solutions, the one nearest to `near`. Axes that the
  /// solution does not need keep their positions from `near`.
  ///   law      forward(*inverse(pose, near, l), l) == pose
  ///   returns  nullopt if no axis positions within the limits give the pose
  std::optional<Axes> inverse(const Pose& pose, const Axes& near, double tool_length) const;

  /// Converts the machine to the parameters of NCT 25.1.
  ///   returns  the converted machine, or an error sentence with the reason why the machine does not fit
  tl::expected<FiveAxis, std::string> five_axis() const;

 private:
  static double position(const MachineJoint& joint, const Axes& axes);
  Vec3 direction(const Axes& axes) const { return forward(axes, 0).direction; }
  bool turn_to(Vec3 target, Axes& axes) const;
  bool turn_by_steps(Vec3 target, Axes& axes) const;
  bool move_to(Vec3 tip, Axes& axes, double tool_length) const;
  std::vector<const MachineJoint*> joints(bool rotary) const;
  FiveAxis directions(const std::vector<const MachineJoint*>& rotary) const;

  std::vector<MachineJoint> tool_, part_;  // joints of the tool's chain and of the part's chain, in order from the bed
  Vec3 tool_direction_;
};

}  // namespace kadr
