#pragma once
// How the axes of a rapid motion go: together along a line, or each at its own rate until it is there. A parameter of the set-up says it:
// Fanuc 1401#1 LRP, Setting 335 of the Haas, N0421 ROL; of a control without one its file (`rapids_apart` of [behaviour]).

#include <string>
#include <vector>

#include "config/control_def.h"
#include "config/setup.h"

namespace kadr {

/// `axes`: of the channel.
bool rapids_apart(const ControlDef& def, const Setup& setup, const std::vector<std::string>& axes);

}  // namespace kadr
