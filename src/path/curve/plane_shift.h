#pragma once
// shift_in_plane() moves the end of a motion in its plane, in work coordinates and in machine coordinates.

#include "action/tool_position.h"

namespace kadr {

/// Moves the end of a motion by the vector `by` in the plane of the axes `first` and `second`. In machine coordinates the vector is rotated
/// in the same manner as the coordinate frame. Slave axes of these two axes (nct 20.2) move too.
inline void shift_in_plane(Motion& motion, std::size_t first, std::size_t second, Vec2 by, const FrameTurn* turn) {
  if (by == Vec2{}) return;
  // The usual case: there is neither a rotated frame nor a slave axis, so the same vector applies in work and machine coordinates.
  if (turn == nullptr && !motion.detail) {
    motion.to[first] += by.x;
    motion.to[second] += by.y;
    motion.machine[first] += by.x;
    motion.machine[second] += by.y;
    return;
  }
  const Axes before = turned(turn, motion.to);
  motion.to[first] += by.x;
  motion.to[second] += by.y;
  const Axes now = turned(turn, motion.to);
  const AxisMask parked = motion.detail ? motion.detail->parked : 0;
  for (std::size_t i = 0; i < max_axes; ++i)
    if ((parked >> i & 1U) == 0) motion.machine[i] += now[i] - before[i];
  if (!motion.detail) return;
  for (const Follower& f : motion.detail->followers) {
    const double travel = f.sign * (now[f.master] - before[f.master]);
    motion.to[f.axis] += travel;
    if ((parked >> f.axis & 1U) == 0) motion.machine[f.axis] += travel;
  }
}

}  // namespace kadr
