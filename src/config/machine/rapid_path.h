#pragma once
// Decides how the axes move in a rapid: together along a straight line, or each at its own rate until it reaches its end. A parameter of
// the set-up decides: Fanuc 1401#1 LRP, Setting 335 of the Haas, N0421 ROL. For a control without such a parameter, its file decides
// (`rapids_apart` of [behaviour]).

#include <string>
#include <vector>

#include "config/control/control_def.h"
#include "config/setup/setup.h"

namespace kadr {

/// Returns true if each axis moves at its own rate. `axes`: names of the channel's axes.
bool rapids_apart(const ControlDef& def, const Setup& setup, const std::vector<std::string>& axes);

}  // namespace kadr
