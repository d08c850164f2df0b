#pragma once
// Looks up a control's codes by what they do, and writes them as that control does.

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "config/control_def.h"

namespace kadr {

inline constexpr int any_argument = -1;
/// A function and its variant (CodeRow::arg); any_argument matches every variant.
using Wanted = std::pair<Function, int>;

/// Returns the row's code with as many digits as the control's format prints: G01 (spec/gost 3: 3G2).
std::string with_digits(const ControlDef& def, const CodeRow& row);

/// Returns an M code with as many digits as the control's format prints.
std::string machine_code_text(const ControlDef& def, std::uint32_t code);

/// Tries the wanted functions in their order and returns the first row of the table that does one and works; nullptr if there is none.
const CodeRow* row_that_does(const ControlDef& def, std::initializer_list<Wanted> wanted);

/// Like row_that_does(), but returns the code as the control writes it; nullopt if there is none.
std::optional<std::string> code_of(const ControlDef& def, std::initializer_list<Wanted> wanted);

/// In a table of coded feeds or speeds, returns the code of the highest value that is not above `wanted` (spec/gost 3); nullopt if all
/// values are above it.
std::optional<double> code_below(const std::map<std::int32_t, double>& codes, double wanted);

}  // namespace kadr
