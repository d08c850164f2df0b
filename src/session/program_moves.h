#pragma once
// Reads a program back as its motions in work coordinates. Tables, work offsets and correctors are empty, as the program assumes.

#include <string>
#include <vector>

#include "base/result.h"
#include "config/control_def.h"
#include "path/area/mill.h"

namespace kadr {

/// Returns the motions of a program, as the control's interpreter creates them; the program starts at the control's zero.
///   alarms  as the program raises
Result<std::vector<area::Move>> program_moves(const ControlDef& def, const std::string& program);

}  // namespace kadr
