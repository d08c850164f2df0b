#pragma once
// Executes a program and returns its motions in work coordinates. Tool tables, work offsets and correctors are empty, because a generated
// program must not depend on their values.

#include <string>
#include <vector>

#include "base/result.h"
#include "config/control/control_def.h"
#include "path/pocketing/mill.h"

namespace kadr {

/// Returns the motions that the control's interpreter creates. The program starts with all axes at 0.
///   alarms  the first alarm that the program raises
Result<std::vector<area::Move>> program_moves(const ControlDef& def, const std::string& program);

}  // namespace kadr
