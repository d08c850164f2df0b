// machine_extents() computes the bounding box of a motion in machine coordinates, also in rotated frames (nct 10.2.3). Used by
// machine/virtual_machine and path/curve/machine_path.

#include "path/curve/machine_extents.h"

#include <algorithm>
#include <tuple>

#include "base/extremes.h"
#include "path/curve/machine_path.h"

namespace kadr {
namespace {

/// Computes the box from samples of the position of each axis along the motion. This works for all types of motion.
Extents sampled(const AxisRoles& roles, const ToolPosition& from, const Motion& motion, const Curve& curve) {
  Extents box{from.machine, from.machine};
  for (std::size_t i = 0; i < roles.count; ++i) {
    const Range range = range_of([&](double part) { return machine_along(roles, from, motion, curve.at(part), part)[i]; }, curve.samples());
    box.least[i] = range.least;
    box.most[i] = range.most;
  }
  return box;
}

}  // namespace

Extents machine_extents(const AxisRoles& roles, const ToolPosition& from, const Motion& motion, const Curve& curve) {
  if (controls_tip(from, motion)) return MachinePath(roles, from, motion, curve).extents(0, 1);
  const bool parked = motion.detail && motion.detail->parked != 0;
  if (parked || (from.turn && !from.turn->drives.is_own)) return sampled(roles, from, motion, curve);
  Extents box = curve.extents();
  const AxisMask rolled = motion.detail ? motion.detail->rolled : 0;
  for (std::size_t i = 0; i < roles.count; ++i) {
    if ((rolled >> i & 1U) != 0) {
      std::tie(box.least[i], box.most[i]) = std::minmax({from.machine[i], motion.machine[i]});
      continue;
    }
    const auto [low, high] = std::minmax({from.machine[i] - from.work[i], motion.machine[i] - motion.to[i]});
    box.least[i] += low;
    box.most[i] += high;
  }
  if (!from.turn) return box;
  for (const std::int8_t main : from.turn->main) {
    if (main < 0) continue;
    const auto axis = static_cast<std::size_t>(static_cast<unsigned char>(main));
    const Range range =
        range_of([&](double part) { return machine_along(roles, from, motion, curve.at(part), part)[axis]; }, curve.samples());
    box.least[axis] = range.least;
    box.most[axis] = range.most;
  }
  for (std::size_t n = 0; motion.detail && n < motion.detail->followers.size(); ++n) {
    const auto [axis, master, sign] = motion.detail->followers[n];
    const double one = sign * (box.least[master] - from.machine[master]), other = sign * (box.most[master] - from.machine[master]);
    box.least[axis] = from.machine[axis] + std::min(one, other);
    box.most[axis] = from.machine[axis] + std::max(one, other);
  }
  return box;
}

}  // namespace kadr
