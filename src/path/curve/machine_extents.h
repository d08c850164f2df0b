#pragma once
// machine_extents(): the bounding box of a motion in machine coordinates, turned frames included (nct 10.2.3).

#include "action/curve.h"
#include "action/tool_position.h"

namespace kadr {

/// Of axes that roll over: only the ends. What machine and work coordinates differ by may change along the motion: there the
/// box is the work box plus the greater of both differences, not smaller than the true one.
///   curve  of the motion from there
Extents machine_extents(const AxisRoles& roles, const ToolPosition& from, const Motion& motion, const Curve& curve);
inline Extents machine_extents(const AxisRoles& roles, const ToolPosition& from, const Motion& motion) {
  return machine_extents(roles, from, motion, Curve(roles, from.work, motion));
}

}  // namespace kadr
