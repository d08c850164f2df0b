#pragma once
// Chain: what carries what on a machine, from the axes' positions to the tool. So far the machine whose linear axes X, Y, Z stand at right
// angles and carry a tool along Z: rotary axes and further linear ones turn and move the part or something else, and the tool's tip is
// where X, Y, Z are. Whoever asks where the tool is asks here, so that five axes (NCT 25) become another chain, not another question.

#include <optional>

#include "action/axis_roles.h"
#include "action/placement.h"

namespace kadr {

class Chain {
 public:
  /// The axes X, Y, Z of a channel; one that it has not stands at 0.
  explicit Chain(const AxisRoles& roles) : xyz_(roles.xyz) {}

  /// Where the tool is; `axes`: of the machine, or work coordinates, then in the work system.
  Pose forward(const Axes& axes) const { return {tip(axes), {0, 0, 1}}; }
  /// The same of work coordinates, in the work system where a programming frame lies otherwise.
  Vec3 tip(const WorkSpace* space, const Axes& work) const { return tip(space == nullptr ? work : space->in_system(work)); }
  Vec3 tip(const Axes& axes) const { return {value(axes, 0), value(axes, 1), value(axes, 2)}; }

  /// The positions at which the tool is there; all axes that do not move it as in `near`.
  ///   returns  nothing: no position of the axes gives that direction, or an axis is missing
  ///   law      forward(*inverse(pose, near)) == pose
  std::optional<Axes> inverse(const Pose& pose, const Axes& near) const;

 private:
  double value(const Axes& axes, std::size_t letter) const { return xyz_[letter] < 0 ? 0 : axes[static_cast<std::size_t>(xyz_[letter])]; }

  std::array<int, 3> xyz_;
};

/// Zero of the work system, machine coordinates.
inline Vec3 zero_of(const Chain& chain, const Placement& placement) {
  return placement.space && placement.space->has_rotary() ? placement.space->zero() : chain.tip(placement.origin);
}

}  // namespace kadr
