// MachinePath: the way of one motion in machine coordinates, and the bounding boxes of its pieces: what a guard of the axes looks at. For
// machine/zone_box, motion/least_time/axis_motion; tested by tests/path/machine_path_test.cpp.

#include "path/curve/machine_path.h"

namespace kadr {

MachinePath::MachinePath(const AxisRoles& roles, const ToolPosition& from, const Motion& motion, const Curve& curve)
    : roles_(roles), from_(from), motion_(motion), curve_(curve), end_(motion.machine) {
  for (std::size_t i = 0; i < roles.count; ++i)
    if (rolls_over(i)) end_[i] = from.machine[i] + motion.detail->travel[i];
}

Axes MachinePath::at(double part) const {
  if (part <= 0) return start();
  if (part >= 1) return end_;
  if (!straight()) return machine_along(roles_, from_, motion_, curve_.at(part), part);
  Axes point = start();
  for (std::size_t i = 0; i < roles_.count; ++i) point[i] += part * (end_[i] - point[i]);
  return point;
}

Extents MachinePath::extents(double from, double to) const {
  if (straight()) {
    Extents box{at(from), at(to)};
    for (std::size_t i = 0; i < roles_.count; ++i)
      if (box.least[i] > box.most[i]) std::swap(box.least[i], box.most[i]);
    return box;
  }
  if (from <= 0 && to >= 1) return machine_extents(roles_, from_, motion_, curve_);
  const ToolPosition piece_from{curve_.at(from), at(from), from_.turn};
  Motion piece = motion_;
  piece.to = curve_.at(to);
  piece.machine = at(to);
  piece.turns = motion_.turns * (to - from);
  if (motion_.detail) {
    auto detail = std::make_shared<MotionDetail>(*motion_.detail);
    for (double& way : detail->travel) way *= to - from;
    detail->flat_from = curve_.flat(from);
    detail->flat_to = curve_.flat(to);
    piece.detail = std::move(detail);
  }
  return machine_extents(roles_, piece_from, piece);
}

}  // namespace kadr
