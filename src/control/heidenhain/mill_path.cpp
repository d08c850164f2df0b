// Adds the moves of a milling cycle to its steps. Used by control/heidenhain.

#include "control/heidenhain/mill_path.h"

#include <cmath>

#include "base/tolerance.h"

namespace kadr::heidenhain {

void MillPath::add(Vec2 to, double height, double feed) {
  const bool in_plane = length(to - at_) > tol::same_point, along_axis = std::fabs(height - height_) > tol::same_point;
  if (!in_plane && !along_axis) return;
  CycleStep& step = steps_.emplace_back();
  step.kind = feed < 0 ? CycleStep::Kind::rapid : CycleStep::Kind::feed;
  step.value = feed;
  if (in_plane) step.named = mask_of(plane_);
  if (along_axis) step.named |= AxisMask{1} << plane_.normal;
  step.to[plane_.first] = to.x;
  step.to[plane_.second] = to.y;
  step.to[plane_.normal] = height;
  at_ = to;
  height_ = height;
}

void MillPath::raise(double height, double feed) { add(at_, height, feed); }
void MillPath::move(Vec2 to, double feed) { add(placed(to), height_, feed); }
void MillPath::slope(Vec2 to, double height, double feed) { add(placed(to), height, feed); }

void MillPath::helix(Vec2 to, double height, Vec2 centre, double turns, bool clockwise, double feed) {
  CycleStep& step = steps_.emplace_back();
  step.kind = CycleStep::Kind::arc;
  step.value = feed;
  step.named = mask_of(plane_) | AxisMask{1} << plane_.normal;
  at_ = placed(to);
  height_ = height;
  step.to[plane_.first] = at_.x;
  step.to[plane_.second] = at_.y;
  step.to[plane_.normal] = height_;
  step.centre = placed(centre);
  step.turns = turns;
  step.clockwise = clockwise;
}

void MillPath::follow(const std::vector<RingMove>& moves, bool clockwise, double feed) {
  for (const RingMove& each : moves) {
    const bool other_way = each.turns < 0;  // the inner wall of a slot along a circle
    if (each.turns == 0) move(each.to, feed);
    else arc(each.to, each.centre, std::fabs(each.turns), clockwise != other_way, feed);
  }
}

}  // namespace kadr::heidenhain
