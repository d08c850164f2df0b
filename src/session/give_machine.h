#pragma once
// What the control of a machine has been told by its builder, from the machine's file, where the set-up says nothing: end positions of the
// axes, and of a machine with rotary axes its kinematics (nct N3200 to N3224) and which axes it has.

#include "config/control_def.h"
#include "config/machine_profile.h"
#include "config/setup.h"

namespace kadr {

/// Does nothing of parameters for a control that has none of those numbers. A chain that they cannot say is left out: the first code that
/// needs it tells so.
void give_machine(Setup& setup, const MachineProfile& profile, const ControlDef& control);

}  // namespace kadr
