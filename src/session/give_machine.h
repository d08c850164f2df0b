#pragma once
// give_machine: copies into the set-up, where it says nothing, what the builder of the machine sets on the control. Source is the machine's
// file: end positions of the axes and, for a machine with rotary axes, its kinematics (nct N3200 to N3224) and its list of axes.

#include "config/control_def.h"
#include "config/machine_profile.h"
#include "config/setup.h"

namespace kadr {

/// Leaves out parameters that the control does not have, and a chain that they cannot express: the first code that needs the chain raises
/// an alarm.
void give_machine(Setup& setup, const MachineProfile& profile, const ControlDef& control);

}  // namespace kadr
