#pragma once
// ToolPosition: the tool's position, tracked from action to action. The functions below compute the positions of the machine's axes along a
// motion.

#include <memory>
#include <variant>

#include "action/action.h"
#include "action/axis_roles.h"

namespace kadr {

/// The position of the tool point, and the orientation of the work system. Control::ending() returns both for the start of a run.
struct ToolPosition {
  Axes work{};
  Axes machine{};
  std::shared_ptr<const FrameTurn> turn{};       // rotation of the frame; nullptr: no rotation
  std::shared_ptr<const WorkTransform> space{};  // transformation in space; nullptr: no such transformation

  void take(const Motion& motion) {
    work = motion.to;
    machine = motion.machine;
  }
  void take(const FrameChange& frame) {
    work = frame.work;
    turn = frame.placement.turn;
    space = frame.placement.space;
  }
  void take(const Action& action) {
    if (const auto* motion = std::get_if<Motion>(&action.what)) take(*motion);
    else if (const auto* frame = std::get_if<FrameChange>(&action.what)) take(*frame);
  }
};

/// Returns true if the motion has tool centre point control, so that the positions of the axes follow from the tip's path.
inline bool controls_tip(const ToolPosition& from, const Motion& motion) {
  return from.space && from.space->controls_tip() && !(motion.detail && motion.detail->evenly);
}

/// Returns the machine coordinates at `part` (0 to 1) of a motion with tool centre point control (nct 25.14). The tip's position comes from
/// the motion's TipPath or, without a TipPath, from the work coordinates; the axis positions are computed from the tip's position.
inline Axes led_along(const ToolPosition& from, const Motion& motion, const Axes& work, double part) {
  if (part <= 0) return from.machine;
  if (part >= 1) return motion.machine;
  const TipPath* const tip_path = motion.detail ? motion.detail->tip_path.get() : nullptr;
  const Axes tool = tip_path != nullptr ? tip_path->at(part, work) : work;
  Axes plainly = motion.machine;
  for (std::size_t i = 0; i < max_axes; ++i) plainly[i] += tool[i] - motion.to[i];
  return from.space->machine_of(tool, plainly);
}

/// Returns the position of the tip relative to the part, in the work system, at `part` (0 to 1) of a motion with tool centre point control.
inline Vec3 controlled_tip(const AxisRoles& roles, const ToolPosition& from, const Motion& motion, const Axes& work, double part) {
  const TipPath* const tip_path = motion.detail ? motion.detail->tip_path.get() : nullptr;
  const Axes at = from.space->in_system(tip_path != nullptr ? tip_path->at(part, work) : work);
  const auto of = [&](std::size_t i) { return roles.xyz[i] < 0 ? 0.0 : at[static_cast<std::size_t>(roles.xyz[i])]; };
  return {of(0), of(1), of(2)};
}

/// Sets the follower axes and the parked axes in `machine`. A follower axis copies the travel of its master, or the calculated travel if
/// the master is parked. A parked axis keeps its position from the start of the motion. `turned_work`: work coordinates at `part`, rotated
/// by the frame.
inline void follow_along(const ToolPosition& from, const Motion& motion, const Axes& turned_work, double part, Axes& machine) {
  const AxisMask parked = motion.detail->parked;
  const auto stands = [&](std::size_t axis) { return (parked >> axis & 1U) != 0; };
  const Axes start = parked != 0 ? turned(from.turn.get(), from.work) : Axes{};
  for (const Follower& f : motion.detail->followers) {
    const double travel = stands(f.master) ? turned_work[f.master] - start[f.master] : machine[f.master] - from.machine[f.master];
    machine[f.axis] = part < 1 ? from.machine[f.axis] + f.sign * travel : motion.machine[f.axis];
  }
  for (AxisMask left = parked; left != 0; left &= left - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(left));
    machine[axis] = from.machine[axis];
  }
}

/// Returns the machine coordinates at `part` (0 to 1) of a motion, where the work coordinates are `work`. The difference between machine
/// coordinates and (rotated) work coordinates is constant along the motion, or changes evenly over it (2С42: a tool length that the next
/// motion applies). Inside the motion, the position of an axis that rolls over continues beyond 360°.
inline Axes machine_along(const AxisRoles& roles, const ToolPosition& from, const Motion& motion, const Axes& work, double part) {
  if (controls_tip(from, motion)) return led_along(from, motion, work, part);
  const FrameTurn* const turn = from.turn.get();
  const Axes start = turned(turn, from.work), end = turned(turn, motion.to);
  Axes machine = turned(turn, work);
  for (std::size_t i = 0; i < roles.count; ++i)
    machine[i] += (1 - part) * (from.machine[i] - start[i]) + part * (motion.machine[i] - end[i]);
  if (!motion.detail) return machine;
  if (motion.detail->rolled != 0)
    for (std::size_t i = 0; i < roles.count; ++i)
      if ((motion.detail->rolled >> i & 1U) != 0)
        machine[i] = part < 1 ? from.machine[i] + part * motion.detail->travel[i] : motion.machine[i];
  if (!motion.detail->followers.empty() || motion.detail->parked != 0) follow_along(from, motion, turned(turn, work), part, machine);
  return machine;
}

}  // namespace kadr
