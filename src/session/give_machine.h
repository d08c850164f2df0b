#pragma once
// give_machine: adds to the set-up the values that a machine builder sets on the control, as far as the set-up does not state them. The
// values come from the machine's file: end positions of the axes, for a machine with rotary axes its kinematics (nct N3200 to N3224) and
// its list of axes, for a lathe's control the list of axes.

#include "config/control/control_def.h"
#include "config/machine/machine_profile.h"
#include "config/setup/setup.h"

namespace kadr {

/// Adds the values to `setup`. A control whose set-up states the kinematics in words (heidenhain, sinumerik) gets them so. Parameters that
/// the control does not have are omitted. A chain of axes that the parameters cannot express is omitted too; then the first code that needs
/// the chain raises an alarm.
void give_machine(Setup& setup, const MachineProfile& profile, const ControlDef& control);

}  // namespace kadr
