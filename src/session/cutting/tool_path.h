#pragma once
// ToolPath: computes the path of the tool over the part, step by step, as straight pieces. All pieces are in one work system: the one in
// force at the first motion at feed. Other work systems are located by their zero points on the machine. If rotary axes turn the tool or
// the part, the path is computed for the part as it was when its zero was measured (rotary axes at 0 unless stated), so that the tool
// appears tilted.

#include <memory>
#include <optional>
#include <vector>

#include "action/step.h"
#include "kinematics/chain.h"
#include "kinematics/machine_tree.h"

namespace kadr {

/// A straight piece of a motion of the tool.
struct PathSegment {
  Vec3 from, to;        // start and end of the tool tip, in machine coordinates without the tool length
  double begins, ends;  // start and end as parts of the motion, 0 to 1
  // direction from the tip into the tool; between start and end it rotates evenly by the shortest rotation
  Vec3 from_direction{0, 0, 1}, to_direction{0, 0, 1};
};

class ToolPath {
 public:
  /// `chord`: mm by which a piece may deviate from an arc.
  /// `system`: row of the work offset table whose work system is used, without shifts by G52 or G92; nullopt: the system of the first
  /// feed motion.
  /// `tree`: the machine's kinematics; nullptr: its file does not describe them.
  /// `apart`: rapid rates of the machine's axes if each moves at its own rate (DogLeg); nullopt: rapid motions are straight lines.
  ToolPath(const AxisRoles& roles, double chord, std::optional<std::uint16_t> system, std::shared_ptr<const MachineTree> tree = nullptr,
           const std::optional<Axes>& apart = {});

  /// Consumes the step.
  ///   pieces  receives the pieces of the step's motion; none if the tool does not move
  void take(const Step& step, std::vector<PathSegment>& pieces);

  /// Returns the machine position after the part `part` of the step's motion, 0 to 1.
  ///   pre  step.motion()
  static Axes axes_at(const Step& step, double part);

  /// Zero point of the work system, in the coordinates of the pieces; nullopt until that work system has been in force.
  const std::optional<Vec3>& zero() const { return zero_; }
  /// Tool length along the tool's axis that the control applied on the last motion, mm.
  double length_in_force() const { return length_; }
  /// The zero point that is in force now. It is used if no work system has been named.
  Vec3 present_origin() const { return work_origin_of(chain_, placement_); }

 private:
  bool turns(const Step& step) const;
  Placement without_shift() const;
  double length_on(const Step& step) const;
  Pose pose_of(const Step& step, const Axes& work, double part) const;
  static Axes work_at(const Step& step, double part);
  Pose pose_at(const Step& step, double part) const;
  void divide(const Step& step, const PathSegment& piece, int depth, std::vector<PathSegment>& pieces) const;
  bool bent(const Step& step, std::vector<PathSegment>& pieces) const;

  std::shared_ptr<const MachineTree> tree_;  // nullptr: the channel has none of the machine's rotary axes
  Chain chain_;
  double chord_;
  std::optional<std::uint16_t> system_;
  std::optional<Axes> apart_;
  Placement placement_;
  std::shared_ptr<const Axes> shifted_;  // shift by G52 or G92: FrameChange::shifted
  double length_ = 0;
  std::optional<Vec3> zero_;
};

/// True for the kinds of motion that remove material.
bool is_cutting(MotionKind kind);

}  // namespace kadr
