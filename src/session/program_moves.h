#pragma once
// Executes a program and returns its motions in work coordinates. Tool tables, work offsets and correctors are empty, as a generated
// program assumes.

#include <string>
#include <vector>

#include "base/result.h"
#include "config/control/control_def.h"
#include "path/pocketing/mill.h"

namespace kadr {

/// Returns the motions as the control's interpreter creates them. The program starts with all axes at 0.
///   alarms  those that the program raises
Result<std::vector<area::Move>> program_moves(const ControlDef& def, const std::string& program);

}  // namespace kadr
