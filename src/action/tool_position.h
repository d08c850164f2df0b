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
  std::shared_ptr<const FrameTurn> turn{};  // nullptr: none

  void take(const Motion& motion) {
    work = motion.to;
    machine = motion.machine;
  }
  void take(const FrameChange& frame) {
    work = frame.work;
    turn = frame.placement.turn;
  }
  void take(const Action& action) {
    if (const auto* motion = std::get_if<Motion>(&action.what)) take(*motion);
    else if (const auto* frame = std::get_if<FrameChange>(&action.what)) take(*frame);
  }
};

/// Machine coordinates at the `part` of a motion where the work coordinates are `work`. What lies between the two (the work
/// coordinates turned, if the frame is) is the same along the motion, or taken up evenly by it (a tool length that the next
/// motion takes out, 2С42). An axis that rolls over counts on beyond its turn until the end.
inline Axes machine_along(const AxisRoles& roles, const ToolPosition& from, const Motion& motion, const Axes& work, double part) {
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
  for (const Follower& f : motion.detail->followers)
    machine[f.axis] = part < 1 ? from.machine[f.axis] + f.sign * (machine[f.master] - from.machine[f.master]) : motion.machine[f.axis];
  return machine;
}

}  // namespace kadr
