#pragma once
// A program read back: its motions in work coordinates. Tables, zeros and correctors are empty, as the program was written for.

#include <string>
#include <vector>

#include "base/result.h"
#include "config/control_def.h"
#include "path/area/mill.h"

namespace kadr {

/// The motions of a program, as the control's interpreter makes them; it starts at the control's zero.
///   alarms  those of the program
Result<std::vector<area::Move>> program_moves(const ControlDef& def, const std::string& program);

}  // namespace kadr
