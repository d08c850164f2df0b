#pragma once
// Describes a parameter of a control, for commands such as `kadr explain nct N1339`.

#include <optional>
#include <string>

#include "config/alarm_texts.h"
#include "config/control/control_def.h"

namespace kadr {

/// Returns the description of a parameter, which is found by number ("N1339", "1339", "N0106", "106"), or by name (CLRG) if it has no
/// number.
///   returns  nullopt if the control has no such parameter
std::optional<std::string> explain_parameter(const ControlDef& def, const std::string& code, Lang lang);

}  // namespace kadr
