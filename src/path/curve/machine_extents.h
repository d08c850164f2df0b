#pragma once
// machine_extents(): the bounding box of a motion in machine coordinates, including rotated frames (nct 10.2.3).

#include "action/curve.h"
#include "action/tool_position.h"

namespace kadr {

/// Returns the box. For axes that roll over, it covers the ends only. The difference between machine and work coordinates may change
/// along the motion: then the box is the work box extended by the smaller and the greater of the differences at the ends, so it contains
/// the true one.
///   curve  the curve of the motion that starts at `from`
Extents machine_extents(const AxisRoles& roles, const ToolPosition& from, const Motion& motion, const Curve& curve);
inline Extents machine_extents(const AxisRoles& roles, const ToolPosition& from, const Motion& motion) {
  return machine_extents(roles, from, motion, Curve(roles, from.work, motion));
}

}  // namespace kadr
