#pragma once
// Which axes are X, Y, Z and which are rotary; and where the tool stands, followed from Action to Action.

#include <algorithm>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "action/action.h"

namespace kadr {

/// What the rooms after `control` know of a channel's axes.
struct AxisRoles {
  std::size_t count = 3;
  AxisMask rotary = 0;
  std::array<int, 3> xyz{0, 1, 2};  // places of X, Y, Z among the axes; -1: there is none

  static AxisRoles of(const std::vector<std::string>& names, AxisMask rotary) {
    AxisRoles roles{std::min(names.size(), max_axes), rotary, {-1, -1, -1}};
    for (std::size_t i = 0; i < roles.count; ++i)
      if (names[i].size() == 1 && names[i][0] >= 'X' && names[i][0] <= 'Z')
        roles.xyz[static_cast<std::size_t>(names[i][0] - 'X')] = static_cast<int>(i);
    return roles;
  }

  bool is_rotary(std::size_t axis) const { return (rotary >> axis & 1U) != 0; }
  double value(const Axes& axes, std::size_t letter) const { return xyz[letter] < 0 ? 0 : axes[static_cast<std::size_t>(xyz[letter])]; }
  Vec3 point(const Axes& axes) const { return {value(axes, 0), value(axes, 1), value(axes, 2)}; }
};

/// Work coordinates turned with the frame: `turn · work` on the main axes (nct 10.2.3); the others stay.
inline Axes turned(const FrameRotation* rotation, const Axes& work) {
  if (rotation == nullptr) return work;
  const auto value = [&](std::int8_t axis) { return axis < 0 ? 0 : work[static_cast<std::size_t>(axis)]; };
  const Vec3 v{value(rotation->main[0]), value(rotation->main[1]), value(rotation->main[2])};
  Axes all = work;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 row = rotation->rows[i];
    if (rotation->main[i] >= 0) all[static_cast<std::size_t>(rotation->main[i])] = row.x * v.x + row.y * v.y + row.z * v.z;
  }
  return all;
}

/// Where the tool point is, and how its work system lies. At the start: Control::ending() before the first block.
struct ToolPosition {
  Axes work{};
  Axes machine{};
  std::shared_ptr<const FrameRotation> rotation{};  // nullptr: none

  void take(const Motion& motion) {
    work = motion.to;
    machine = motion.machine;
  }
  void take(const FrameChange& frame) {
    work = frame.work;
    rotation = frame.rotation;
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
  const FrameRotation* const rotation = from.rotation.get();
  const Axes start = turned(rotation, from.work), end = turned(rotation, motion.to);
  Axes machine = turned(rotation, work);
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
