#pragma once
// machine_extents() computes the bounding box of a motion in machine coordinates, also in rotated frames (nct 10.2.3).

#include "action/curve.h"
#include "action/tool_position.h"

namespace kadr {

/// Returns the bounding box of a motion in machine coordinates. For axes with rollover, the box covers only the start and the end of the
/// motion. If the difference between machine and work coordinates changes along the motion, the result is the box in work coordinates,
/// extended by the smaller and the greater difference at the two ends of the motion. The result therefore contains the exact box.
///   curve  the curve of the motion that starts at `from`
Extents machine_extents(const AxisRoles& roles, const ToolPosition& from, const Motion& motion, const Curve& curve);
inline Extents machine_extents(const AxisRoles& roles, const ToolPosition& from, const Motion& motion) {
  return machine_extents(roles, from, motion, Curve(roles, from.work, motion));
}

}  // namespace kadr
