#pragma once
// A parameter of a control for people: kadr explain nct N1339.

#include <optional>
#include <string>

#include "config/alarm_texts.h"
#include "config/control_def.h"

namespace kadr {

/// What the table of parameters says of "N1339", "1339", "N0106" or "106", of one without a number by its name (CLRG).
///   returns  nothing, if the control has no such parameter
std::optional<std::string> explain_parameter(const ControlDef& def, const std::string& code, Lang lang);

}  // namespace kadr
