// Computes the axis positions from a pose of the tool. Tested by tests/kinematics/chain_test.cpp.

#include "kinematics/chain.h"

#include <cmath>

#include "base/tolerance.h"

namespace kadr {

std::optional<Axes> Chain::inverse(const Pose& pose, const Axes& near) const {
  const Vec3 d = pose.direction;
  constexpr double same_direction = 1e-12;  // greatest angle, in radians, between Z and a direction that counts as parallel to Z
  if (!(d.z > 0) || std::hypot(d.x, d.y) > same_direction) return std::nullopt;
  Axes axes = near;
  const double tip[] = {pose.tip.x, pose.tip.y, pose.tip.z};
  for (std::size_t letter = 0; letter < 3; ++letter) {
    if (xyz_[letter] >= 0) axes[static_cast<std::size_t>(xyz_[letter])] = tip[letter];
    else if (std::fabs(tip[letter]) > tol::same_point) return std::nullopt;
  }
  return axes;
}

}  // namespace kadr
