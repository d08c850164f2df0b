#pragma once
// Finds the code of a control that has a given function, and formats it as that control writes it.

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "config/control/control_def.h"

namespace kadr {

inline constexpr int any_argument = -1;
/// A function and its variant (CodeRow::arg). The variant any_argument matches every variant.
using Wanted = std::pair<Function, int>;

/// Returns the code of the row with as many digits as the control prints: G01 (spec/gost 3: 3G2).
std::string with_digits(const ControlDef& def, const CodeRow& row);

/// Returns an M code with as many digits as the control prints.
std::string machine_code_text(const ControlDef& def, std::uint32_t code);

/// Returns the first row of the control's code table that has one of the wanted functions and is implemented (CodeRow::works). Functions
/// are tried in the given order. Returns nullptr if no row matches.
const CodeRow* row_that_does(const ControlDef& def, std::initializer_list<Wanted> wanted);

/// Like row_that_does(), but returns the code as the control writes it; nullopt if no row matches.
std::optional<std::string> code_of(const ControlDef& def, std::initializer_list<Wanted> wanted);

/// Returns the code of the highest feed or speed that is at most `wanted`, from a table of codes and their values (spec/gost 3); nullopt if
/// all values are greater.
std::optional<double> code_below(const std::map<std::int32_t, double>& codes, double wanted);

}  // namespace kadr
