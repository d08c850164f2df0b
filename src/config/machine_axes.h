#pragma once
// A control whose axes the machine decides (behaviour.machine_axes) made fit for one channel of a machine: addresses of
// axes, spindles and auxiliary functions from the set-up (spec/nct/02, 05 5.1, 11 11.1.1, 13 13.2).

#include <string>

#include "config/control_def.h"
#include "config/setup.h"

namespace kadr {

/// Makes the rows of the axis, spindle and auxiliary addresses. Does nothing where the control's own file names its axes.
///   returns  an error sentence: two names alike, too many names; empty if all is well
std::string fit_to_machine(ControlDef& def, const Setup& setup);

/// A parameter of the set-up as a number; 0 if it is not given. `index`: axis name, or a number as text.
double setup_number(const Setup& setup, const std::string& name, const std::string& index = "", const std::string& bit = "");
bool setup_gives(const Setup& setup, const std::string& name, const std::string& index, const std::string& bit);

}  // namespace kadr
