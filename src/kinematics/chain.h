#pragma once
// Chain: computes the tool's pose from the positions of the axes. It covers machines whose linear axes X, Y, Z are at right angles
// and carry the tool along Z: rotary and further linear axes move the part or something else, so the tip is at X, Y, Z. All callers
// that need the tool's position ask this class, so that five axes (NCT 25) need another chain and no change of the callers.

#include <optional>

#include "action/axis_roles.h"
#include "action/placement.h"

namespace kadr {

class Chain {
 public:
  /// Takes the axes X, Y, Z of a channel; a missing axis is at 0.
  explicit Chain(const AxisRoles& roles) : xyz_(roles.xyz) {}

  /// Returns the pose of the tool. `axes` are machine coordinates, or work coordinates; the pose is then in the work system.
  Pose forward(const Axes& axes) const { return {tip(axes), {0, 0, 1}}; }
  /// Returns the tip for work coordinates, in the work system even where a programming frame is rotated or shifted against it.
  Vec3 tip(const WorkSpace* space, const Axes& work) const { return tip(space == nullptr ? work : space->in_system(work)); }
  Vec3 tip(const Axes& axes) const { return {value(axes, 0), value(axes, 1), value(axes, 2)}; }

  /// Returns the axis positions that give the pose; axes that do not move the tool keep their positions in `near`.
  ///   returns  nullopt if no position of the axes gives that direction, or an axis is missing
  ///   law      forward(*inverse(pose, near)) == pose
  std::optional<Axes> inverse(const Pose& pose, const Axes& near) const;

 private:
  double value(const Axes& axes, std::size_t letter) const { return xyz_[letter] < 0 ? 0 : axes[static_cast<std::size_t>(xyz_[letter])]; }

  std::array<int, 3> xyz_;
};

/// Returns the origin of the work system in machine coordinates.
inline Vec3 zero_of(const Chain& chain, const Placement& placement) {
  return placement.space && placement.space->has_rotary() ? placement.space->zero() : chain.tip(placement.origin);
}

}  // namespace kadr
