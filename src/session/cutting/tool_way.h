#pragma once
// ToolWay: the way of the tool over the part, from Step to Step, as straight pieces in one work system: that in force at the first motion
// at feed. Other work systems lie to it as their zeros do on the machine. Where rotary axes turn the tool or the part, the part is seen as
// it lies where they stood when its zero was measured (0 unless told): the tool leans.

#include <memory>
#include <optional>
#include <vector>

#include "action/step.h"
#include "kinematics/chain.h"
#include "kinematics/machine_tree.h"

namespace kadr {

/// A straight piece of a motion.
struct WayPiece {
  Vec3 from, to;                                        // of the tip, machine coordinates without the tool's length
  double begins, ends;                                  // parts of the motion, 0 to 1
  Vec3 from_direction{0, 0, 1}, to_direction{0, 0, 1};  // from the tip into the tool; evenly between, the shortest way
};

class ToolWay {
 public:
  /// `chord`: mm by which a piece may miss an arc. `system`: row of the table of zeros whose work system is meant, without what G52 or G92
  /// shift it by; nothing: that of the first motion at feed. `tree`: the machine, if its file says how its axes carry each other. `apart`:
  /// rapid rates of the machine's axes where each goes at its own (DogLeg); nothing: rapid motions are lines.
  ToolWay(const AxisRoles& roles, double chord, std::optional<std::uint16_t> system, std::shared_ptr<const MachineTree> tree = nullptr,
          const std::optional<Axes>& apart = {});

  /// Takes the step.
  ///   pieces  of its motion; none where the tool stays
  void take(const Step& step, std::vector<WayPiece>& pieces);

  /// Where the machine's axes stand at a part of its motion.
  ///   pre  step.motion()
  static Axes axes_at(const Step& step, double part);

  /// Zero of the work system, in the coordinates of the pieces; nothing before it is in force.
  const std::optional<Vec3>& zero() const { return zero_; }
  /// Of the tool along itself, as the control reckons with it on the last motion, mm.
  double length_in_force() const { return length_; }
  /// What is in force now, where no zero was named.
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

  std::shared_ptr<const MachineTree> tree_;  // nullptr: no rotary axis of it is in the channel
  Chain chain_;
  double chord_;
  std::optional<std::uint16_t> system_;
  std::optional<Axes> apart_;
  Placement placement_;
  std::shared_ptr<const Axes> shifted_;  // FrameChange::shifted
  double length_ = 0;
  std::optional<Vec3> zero_;
};

/// Where it is a motion that cuts.
bool is_cutting(MotionKind kind);

}  // namespace kadr
