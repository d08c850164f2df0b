#pragma once
// Codes as one control writes them, looked up by what they do.

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "config/control_def.h"

namespace kadr {

inline constexpr int any_argument = -1;
/// A function and which of its kind (CodeRow::arg); any_argument: whichever.
using Wanted = std::pair<Function, int>;

/// As many digits as the format prints (spec/gost 3: 3G2): G01.
std::string with_digits(const ControlDef& def, const CodeRow& row);

/// An M code by its number, with such digits.
std::string machine_code_text(const ControlDef& def, std::uint32_t code);

/// The row that does one of these; of several the first. nullptr: the control has none that works.
const CodeRow* row_that_does(const ControlDef& def, std::initializer_list<Wanted> wanted);

/// Its code as it is written.
std::optional<std::string> code_of(const ControlDef& def, std::initializer_list<Wanted> wanted);

/// Of a coded feed or speed the highest that is not above the one wanted (spec/gost 3); nothing: none is as low.
std::optional<double> code_below(const std::map<std::int32_t, double>& codes, double wanted);

}  // namespace kadr
