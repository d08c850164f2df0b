#pragma once
// Chain: computes the tool's pose (tip and direction) from the positions of the axes. It covers machines whose linear axes X, Y, Z are at
// right angles and whose tool is parallel to Z. Rotary axes and further linear axes do not influence the pose, so the tip is at the
// positions of X, Y, Z. All code that needs the tool's position calls this class; a machine with five axes (NCT 25) needs another chain
// class, but no change in the callers.

#include <optional>

#include "action/axis_roles.h"
#include "action/placement.h"

namespace kadr {

class Chain {
 public:
  /// Uses the axes X, Y, Z of a channel. If the channel lacks one of these axes, its position counts as 0.
  explicit Chain(const AxisRoles& roles) : xyz_(roles.xyz) {}

  /// Returns the pose of the tool. The pose is in machine coordinates if `axes` are machine coordinates, and in the work system if `axes`
  /// are work coordinates.
  Pose forward(const Axes& axes) const { return {tip(axes), {0, 0, 1}}; }
  /// Converts work coordinates to the position of the tip in the work system. The programming frame `space` may be rotated or shifted in
  /// relation to the work system.
  Vec3 tip(const WorkTransform* space, const Axes& work) const { return tip(space == nullptr ? work : space->in_system(work)); }
  Vec3 tip(const Axes& axes) const { return {value(axes, 0), value(axes, 1), value(axes, 2)}; }

  /// Returns the axis positions that give the pose. Axes that do not move the tool keep their positions from `near`.
  ///   returns  nullopt if no axis positions give the pose's direction, or if X, Y or Z is missing
  ///   law      forward(*inverse(pose, near)) == pose
  std::optional<Axes> inverse(const Pose& pose, const Axes& near) const;

 private:
  double value(const Axes& axes, std::size_t letter) const { return xyz_[letter] < 0 ? 0 : axes[static_cast<std::size_t>(xyz_[letter])]; }

  std::array<int, 3> xyz_;
};

/// Returns the origin of the work system in machine coordinates.
inline Vec3 work_origin_of(const Chain& chain, const Placement& placement) {
  return placement.space && placement.space->has_rotary() ? placement.space->zero() : chain.tip(placement.origin);
}

}  // namespace kadr
