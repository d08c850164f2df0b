#pragma once
// machine_extents(): the bounding box of a motion in machine coordinates, turned frames included (nct 10.2.3).

#include "path/curve.h"

namespace kadr {

/// Of axes that roll over: only the ends. What machine and work coordinates differ by may change along the motion: there the
/// box is the work box plus the greater of both differences, not smaller than the true one.
Extents machine_extents(const AxisRoles& roles, const ToolPosition& from, const Motion& motion);

}  // namespace kadr
