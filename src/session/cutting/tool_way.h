#pragma once
// ToolWay: computes the path of the tool over the part, from Step to Step, as straight pieces in one work system: that in force at the
// first motion at feed. Other work systems are placed by their zeros on the machine. If rotary axes turn the tool or the part, the part
// is shown as it was when its zero was measured (at 0 unless stated), so that the tool is tilted.

#include <memory>
#include <optional>
#include <vector>

#include "action/step.h"
#include "kinematics/chain.h"
#include "kinematics/machine_tree.h"

namespace kadr {

/// A straight piece of a motion.
struct WayPiece {
  Vec3 from, to;                                        // of the tip, machine coordinates without the tool length
  double begins, ends;                                  // parts of the motion, 0 to 1
  Vec3 from_direction{0, 0, 1}, to_direction{0, 0, 1};  // from the tip into the tool; interpolated evenly along the shortest rotation
};

class ToolWay {
 public:
  /// `chord`: mm by which a piece may deviate from an arc. `system`: row of the table of zeros whose work system is meant, without shifts
  /// by G52 or G92; nullopt: that of the first motion at feed. `tree`: the machine, if its file describes the chains of axes. `apart`:
  /// rapid rates of the machine's axes if each moves at its own (DogLeg); nullopt: rapid motions are straight lines.
  ToolWay(const AxisRoles& roles, double chord, std::optional<std::uint16_t> system, std::shared_ptr<const MachineTree> tree = nullptr,
          const std::optional<Axes>& apart = {});

  /// Consumes the step.
  ///   pieces  receives the pieces of its motion; none if the tool does not move
  void take(const Step& step, std::vector<WayPiece>& pieces);

  /// Positions of the machine's axes at a part of the step's motion.
  ///   pre  step.motion()
  static Axes axes_at(const Step& step, double part);

  /// Zero of the work system in the coordinates of the pieces; nullopt before that work system is in force.
  const std::optional<Vec3>& zero() const { return zero_; }
  /// Length of the tool along its axis, as the control applies it on the last motion, mm.
  double length_in_force() const { return length_; }
  /// The zero in force now, for when no work system was named.
  Vec3 present_zero() const { return zero_of(chain_, placement_); }

 private:
  bool turns(const Step& step) const;
  Placement without_shift() const;
  double length_on(const Step& step) const;
  Pose pose_of(const Step& step, const Axes& work, double part) const;
  static Axes work_at(const Step& step, double part);
  Pose pose_at(const Step& step, double part) const;
  void divide(const Step& step, const WayPiece& piece, int depth, std::vector<WayPiece>& pieces) const;
  bool bent(const Step& step, std::vector<WayPiece>& pieces) const;

  std::shared_ptr<const MachineTree> tree_;  // nullptr: none of its rotary axes is in the channel
  Chain chain_;
  double chord_;
  std::optional<std::uint16_t> system_;
  std::optional<Axes> apart_;
  Placement placement_;
  std::shared_ptr<const Axes> shifted_;  // FrameChange::shifted
  double length_ = 0;
  std::optional<Vec3> zero_;
};

/// True for the kinds of motion that cut.
bool is_cutting(MotionKind kind);

}  // namespace kadr
