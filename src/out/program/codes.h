#pragma once
// Finds the G or M code with which a control commands a given function, e.g. rapid motion, and formats the code as that control requires.

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "config/control/control_def.h"

namespace kadr {

inline constexpr int any_argument = -1;
/// A function that a code commands, and the variant of the function (CodeRow::arg). The variant any_argument stands for every variant.
using FunctionArg = std::pair<Function, int>;

/// Returns the code of a row of the code table, with as many digits as the control prints, e.g. G01.
std::string with_digits(const ControlDef& def, const CodeRow& row);

/// Returns an M code with as many digits as the control prints.
std::string machine_code_text(const ControlDef& def, std::uint32_t code);

/// Returns the row of the control's code table that commands one of the given functions. Only rows that Kadr implements (CodeRow::works)
/// are considered. The functions are tried in the given order. Returns nullptr if no row matches.
const CodeRow* row_that_does(const ControlDef& def, std::initializer_list<FunctionArg> functions);

/// Finds the same row as row_that_does(), but returns the text of the code with the digits of the control; nullopt if no row matches.
std::optional<std::string> code_of(const ControlDef& def, std::initializer_list<FunctionArg> functions);

/// Returns the code of the highest feed or speed that does not exceed `limit`. `codes`: table of codes and their values (spec/gost 3).
/// Returns nullopt if all values are greater.
std::optional<double> code_below(const std::map<std::int32_t, double>& codes, double limit);

}  // namespace kadr
