#pragma once
// Describes a system variable: its numbers, its symbol, and whether a program may read or change it.

#include <optional>
#include <string>

#include "config/alarm_texts.h"
#include "config/control/control_def.h"

namespace kadr {

/// Returns the numbers of a variable, e.g. "#5001–#5020, #100001–#100050" or "bit 1 of #3004"; empty if it has no number.
std::string numbers_of(const ControlDef& def, const VariableRow& row, Lang lang);

/// Returns the symbol of a variable, e.g. "#_ABSIO[1–50]" or "#_WZP1[1–50] … #_WZP99[1–50]"; empty if it has no symbol.
std::string symbol_of(const VariableRow& row);

/// Returns the text of `kadr explain` about a variable: "#5021", "#_ABSIO", "absio[3]", "WZP7".
///   returns  nullopt if the control has no variable with that number or symbol
std::optional<std::string> explain_variable(const ControlDef& def, const std::string& what, Lang lang);

}  // namespace kadr
