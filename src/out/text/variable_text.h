#pragma once
// A system variable for people: its numbers, its symbol, what may be done with it.

#include <optional>
#include <string>

#include "config/alarm_texts.h"
#include "config/control_def.h"

namespace kadr {

/// "#5001–#5020, #100001–#100050"; "bit 1 of #3004"; empty: it has no number.
std::string numbers_of(const ControlDef& def, const VariableRow& row, Lang lang);

/// "#_ABSIO[1–50]", "#_WZP1[1–50] … #_WZP99[1–50]"; empty: it has no symbol.
std::string symbol_of(const VariableRow& row);

/// What `kadr explain` says of a variable: "#5021", "#_ABSIO", "absio[3]", "WZP7".
///   returns  nothing, if the control has none of that number or symbol
std::optional<std::string> explain_variable(const ControlDef& def, const std::string& what, Lang lang);

}  // namespace kadr
