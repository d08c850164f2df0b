#pragma once
// Adapts a control whose axes depend on the machine (ControlDef::machine_axes()) to one channel of a machine: reads the addresses of axes,
// spindles and auxiliary functions from the set-up (spec/nct/02, 05 5.1, 11 11.1.1, 13 13.2).

#include <string>

#include "config/control/control_def.h"
#include "config/setup/setup.h"

namespace kadr {

/// Creates the rows for the addresses of axes, spindles and auxiliary functions. If the control's own file names its axes, creates no rows,
/// and only reads the values of the machine that the set-up states as parameters.
///   returns  an error sentence (duplicate name, too many names); empty if there is no fault
std::string fit_to_machine(ControlDef& def, const Setup& setup);

/// Returns the id of the control that has the codes of the G-code system which the set-up's parameters select (ControlDef::systems); empty
/// if the control's own codes apply (spec/fanuc-t 1.1).
std::string system_of(const ControlDef& def, const Setup& setup);

/// Values of the machine that a parameter of the control may set. Each pair has the name under which the interpreter uses the parameter
/// (`as` in the control's parameter table) and the member of Behaviour that stores the value.
inline constexpr std::pair<std::string_view, double Behaviour::*> figures_of_machine[] = {
    {"feed_most", &Behaviour::feed_most},
    {"reference_feed", &Behaviour::reference_feed},
    {"return_chip_break", &Behaviour::return_chip_break},
    {"return_near", &Behaviour::return_near},
    {"probe_least_distance", &Behaviour::probe_least_distance},
    {"probe_retract", &Behaviour::probe_retract},
};

/// Returns a parameter of the set-up as a number; 0 if the set-up does not state it. `index`: name of an axis, or a number as text.
double setup_number(const Setup& setup, const std::string& name, const std::string& index = "", const std::string& bit = "");
bool setup_gives(const Setup& setup, const std::string& name, const std::string& index, const std::string& bit);

}  // namespace kadr
