#pragma once
// The two rotary axes of a machine, as the set-up describes them (key `kinematics`), for controls with tilted planes.

#include "config/control/control_def.h"
#include "config/setup/setup.h"
#include "kinematics/five_axis.h"

namespace kadr {

/// Returns the machine with its rotary axes. Its group is MachineGroup::none if the set-up does not name two of them, or if the channel
/// does not have one of them. `missing`: letters of axes that the control knows and the machine does not have, one bit each.
FiveAxis rotary_machine(const KinematicsSetup& given, const ControlDef& def, std::uint64_t missing);

}  // namespace kadr
