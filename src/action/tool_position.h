#pragma once
// ToolPosition: where the tool stands, followed from Action to Action; and where the axes of the machine stand along a motion.

#include <memory>
#include <variant>

#include "action/action.h"
#include "action/axis_roles.h"

namespace kadr {

/// Where the tool point is, and how its work system lies. At the start: Control::ending() before the first block.
struct ToolPosition {
  Axes work{};
  Axes machine{};
  std::shared_ptr<const FrameTurn> turn{};   // nullptr: none
  std::shared_ptr<const WorkSpace> space{};  // nullptr: none

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

/// The motion leads the tool's tip: the axes' ways follow from that.
inline bool leads_tip(const ToolPosition& from, const Motion& motion) {
  return from.space && from.space->leads_tip() && !(motion.detail && motion.detail->evenly);
}

/// The same where the tip is led (nct 25.14): the tool is where the motion's own way or the work coordinates say, and so are the axes.
inline Axes led_along(const ToolPosition& from, const Motion& motion, const Axes& work, double part) {
  if (part <= 0) return from.machine;
  if (part >= 1) return motion.machine;
  const TipWay* const way = motion.detail ? motion.detail->tip_way.get() : nullptr;
  const Axes tool = way != nullptr ? way->at(part, work) : work;
  Axes plainly = motion.machine;
  for (std::size_t i = 0; i < max_axes; ++i) plainly[i] += tool[i] - motion.to[i];
  return from.space->machine_of(tool, plainly);
}

/// Where the tip is then in the part, in the work system.
inline Vec3 led_tip(const AxisRoles& roles, const ToolPosition& from, const Motion& motion, const Axes& work, double part) {
  const TipWay* const way = motion.detail ? motion.detail->tip_way.get() : nullptr;
  const Axes at = from.space->in_system(way != nullptr ? way->at(part, work) : work);
  const auto of = [&](std::size_t i) { return roles.xyz[i] < 0 ? 0.0 : at[static_cast<std::size_t>(roles.xyz[i])]; };
  return {of(0), of(1), of(2)};
}

/// Axes that follow others (of a parked one what is calculated), and those that are parked. `ways`: the work coordinates turned.
inline void follow_along(const ToolPosition& from, const Motion& motion, const Axes& ways, double part, Axes& machine) {
  const AxisMask parked = motion.detail->parked;
  const auto stands = [&](std::size_t axis) { return (parked >> axis & 1U) != 0; };
  const Axes start = parked != 0 ? turned(from.turn.get(), from.work) : Axes{};
  for (const Follower& f : motion.detail->followers) {
    const double way = stands(f.master) ? ways[f.master] - start[f.master] : machine[f.master] - from.machine[f.master];
    machine[f.axis] = part < 1 ? from.machine[f.axis] + f.sign * way : motion.machine[f.axis];
  }
  for (AxisMask left = parked; left != 0; left &= left - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(left));
    machine[axis] = from.machine[axis];
  }
}

/// Machine coordinates at the `part` of a motion where the work coordinates are `work`. What lies between the two (the work
/// coordinates turned, if the frame is) is the same along the motion, or taken up evenly by it (a tool length that the next
/// motion takes out, 2С42). An axis that rolls over counts on beyond its turn until the end.
inline Axes machine_along(const AxisRoles& roles, const ToolPosition& from, const Motion& motion, const Axes& work, double part) {
  if (leads_tip(from, motion)) return led_along(from, motion, work, part);
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
