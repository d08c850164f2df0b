#pragma once
// ToolWay: the way of the tool's tip over the part, from Step to Step, as straight pieces in one work system: that in force at the first
// motion at feed. Other work systems lie to it as their zeros do on the machine.

#include <optional>
#include <vector>

#include "action/step.h"
#include "kinematics/chain.h"

namespace kadr {

/// A straight piece of a motion.
struct WayPiece {
  Vec3 from, to;        // of the tip, machine coordinates without the tool's length
  double begins, ends;  // parts of the motion, 0 to 1
};

class ToolWay {
 public:
  /// `chord`: mm by which a piece may miss an arc. `system`: row of the table of zeros whose work system is meant; nothing: that of the
  /// first motion at feed.
  /// `apart`: rapid rates of the machine's axes where each goes at its own (DogLeg); nothing: rapid motions are lines.
  ToolWay(const AxisRoles& roles, double chord, std::optional<std::uint8_t> system, const std::optional<Axes>& apart = {});

  /// Takes the step.
  ///   pieces   of its motion; none where the tool stays
  ///   returns  false: the tool's axis is not Z of the machine
  bool take(const Step& step, std::vector<WayPiece>& pieces);

  /// Zero of the work system, in the coordinates of the pieces; nothing before it is in force.
  const std::optional<Vec3>& zero() const { return zero_; }
  /// Of the tool along Z, as the control reckons with it, mm.
  double length_in_force() const { return chain_.tip(placement_.length).z; }
  /// What is in force now, where no zero was named.
  Vec3 present_zero() const { return zero_of(chain_, placement_); }

 private:
  Vec3 tip_of(const Step& step, const Axes& work, double part) const;
  bool bent(const Step& step, std::vector<WayPiece>& pieces) const;

  Chain chain_;
  double chord_;
  std::optional<std::uint8_t> system_;
  std::optional<Axes> apart_;
  Placement placement_;
  std::optional<Vec3> zero_;
};

/// Where it is a motion that cuts.
bool is_cutting(MotionKind kind);

}  // namespace kadr
