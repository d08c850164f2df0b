#pragma once
// give_machine: completes the set-up with the values that the machine's builder sets on the control, where the set-up does not state
// them. They come from the machine's file: end positions of the axes and, for a machine with rotary axes, its kinematics (nct N3200 to
// N3224) and its list of axes.

#include "config/control/control_def.h"
#include "config/machine/machine_profile.h"
#include "config/setup/setup.h"

namespace kadr {

/// Omits parameters that the control does not have. Also omits a chain of axes that the parameters cannot express; then the first code
/// that needs the chain raises an alarm.
void give_machine(Setup& setup, const MachineProfile& profile, const ControlDef& control);

}  // namespace kadr
