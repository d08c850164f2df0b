#pragma once
// A control whose axes the machine decides (behaviour.machine_axes) made fit for one channel of a machine: addresses of
// axes, spindles and auxiliary functions from the set-up (spec/nct/02, 05 5.1, 11 11.1.1, 13 13.2).

#include <string>

#include "config/control_def.h"
#include "config/setup.h"

namespace kadr {

/// Makes the rows of the axis, spindle and auxiliary addresses. Where the control's own file names its axes: takes the figures of the
/// machine that the set-up gives as parameters.
///   returns  an error sentence: two names alike, too many names; empty if all is well
std::string fit_to_machine(ControlDef& def, const Setup& setup);

/// Figures of the machine that a table of parameters may hold: what the engine calls them (`as`), where they stand.
inline constexpr std::pair<std::string_view, double Behaviour::*> figures_of_machine[] = {
    {"feed_most", &Behaviour::feed_most},
    {"reference_feed", &Behaviour::reference_feed},
    {"return_chip_break", &Behaviour::return_chip_break},
    {"return_near", &Behaviour::return_near},
    {"probe_least_distance", &Behaviour::probe_least_distance},
    {"probe_retract", &Behaviour::probe_retract},
};

/// A parameter of the set-up as a number; 0 if it is not given. `index`: axis name, or a number as text.
double setup_number(const Setup& setup, const std::string& name, const std::string& index = "", const std::string& bit = "");
bool setup_gives(const Setup& setup, const std::string& name, const std::string& index, const std::string& bit);

}  // namespace kadr
