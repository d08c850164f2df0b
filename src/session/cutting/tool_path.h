#pragma once
// ToolPath: computes the path of the tool over the part, step by step, as straight segments. All segments are in the same work coordinates:
// those in force at the first motion at feed. Other work coordinates are located by their zero points on the machine. If rotary axes turn
// the tool or the part, the path is computed relative to the part. The tool then appears tilted. The part is assumed to be as it was when
// its zero point was measured (rotary axes at 0 unless stated).

#include <memory>
#include <optional>
#include <vector>

#include "action/step.h"
#include "kinematics/chain.h"
#include "kinematics/machine_tree.h"

namespace kadr {

/// A straight segment of a motion of the tool.
struct PathSegment {
  Vec3 from, to;        // start and end of the tool tip, in machine coordinates without the tool length, mm
  double begins, ends;  // start and end of the segment as fractions (0 to 1) of the motion
  // Directions from the tip into the tool (unit vectors) at the start and the end. Between them the tool rotates evenly by the least angle.
  Vec3 from_direction{0, 0, 1}, to_direction{0, 0, 1};
};

class ToolPath {
 public:
  /// `chord`: greatest deviation of a segment from an arc, mm. `system`: row of the work offset table whose work coordinates are used,
  /// without shifts by G52 or G92; nullopt: those of the first motion at feed. `tree`: the machine's kinematics; nullptr: the machine's
  /// file does not describe them. `apart`: rapid rates of the machine's axes, if each axis moves at its own rate (DogLeg); nullopt: rapid
  /// motions are straight lines.
  ToolPath(const AxisRoles& roles, double chord, std::optional<std::uint16_t> system, std::shared_ptr<const MachineTree> tree = nullptr,
           const std::optional<Axes>& apart = {});

  /// Processes the step.
  ///   pieces  receives the segments of the step's motion; empty if the tool does not move
  void take(const Step& step, std::vector<PathSegment>& pieces);

  /// Returns the machine position at the fraction `part` (0 to 1) of the step's motion.
  ///   pre  the step is a motion: step.motion() is not nullptr
  static Axes axes_at(const Step& step, double part);

  /// Returns the zero point of the work coordinates, in the coordinates of the segments; nullopt until those work coordinates have been in
  /// force.
  const std::optional<Vec3>& zero() const { return zero_; }
  /// Returns the tool length that the control applied on the last motion, along the tool's axis, mm.
  double length_in_force() const { return length_; }
  /// Returns the zero point of the work coordinates in force now, for callers that have not named the work offset to use.
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

  std::shared_ptr<const MachineTree> tree_;  // the machine's kinematics; nullptr: the channel has none of the machine's rotary axes
  Chain chain_;
  double chord_;
  std::optional<std::uint16_t> system_;
  std::optional<Axes> apart_;
  Placement placement_;
  std::shared_ptr<const Axes> shifted_;  // shift of the work coordinates by G52 or G92: FrameChange::shifted
  double length_ = 0;
  std::optional<Vec3> zero_;
};

/// True for the kinds of motion that remove material, which are all except rapids, homing and probing.
bool is_cutting(MotionKind kind);

}  // namespace kadr
