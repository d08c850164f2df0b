// ToolDirections: collects directions of the tool along the path. It is used by out/picture/plot/plot and tested by
// tests/out/tool_directions_test.cpp.

#include "out/picture/tool_directions.h"

#include <algorithm>
#include <cmath>

namespace kadr {

void ToolDirections::keep(ToolDirection direction) {
  constexpr double upright = 1e-9;
  leans_ = leans_ || std::hypot(direction.direction.x, direction.direction.y) > upright;
  all_.push_back(direction);
  if (all_.size() < most_) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all_.size(); i += 2) all_[kept++] = all_[i];
  all_.resize(kept);
  next_ += step_;
  step_ *= 2;
}

void ToolDirections::take(const Step& step, Vec3 shift) {
  const Motion& motion = *step.motion();
  const WorkTransform* const space = step.from.space.get();
  if (space == nullptr || !space->has_rotary()) return;
  const Curve& curve = step.curve();
  const double length = curve.length(), begins = travelled_;
  travelled_ += length;
  constexpr int most_of_one = 2000;
  for (int i = 0; i < most_of_one && next_ <= travelled_; ++i) {
    const double part = length > 0 ? std::clamp((next_ - begins) / length, 0.0, 1.0) : 1;
    const Pose pose = space->pose(machine_along(step.roles, step.from, motion, curve.at(part), part));
    next_ += step_;
    keep({pose.tip + shift, pose.direction});
  }
  next_ = std::max(next_, travelled_ - step_);
}

}  // namespace kadr
