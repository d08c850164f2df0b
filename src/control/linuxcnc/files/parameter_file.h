#pragma once
// The file that stores LinuxCNC's parameters between runs (spec/linuxcnc 4.4; restore_parameters, save_parameters of LinuxCNC's source).
// Kadr uses a parameter file only if the ini file names one. Without a name LinuxCNC reads and creates `rs274ngc.var`; Kadr does not,
// because the user has not named this file (INFERRED).

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "base/result.h"

namespace kadr::linuxcnc {

using StoredParameters = std::map<std::uint32_t, double>;

/// Reads the lines that consist of a parameter number and a value; other lines are skipped.
///   returns  the parameters, or LinuxCNC's error text if the numbers are not in increasing order or out of range
tl::expected<StoredParameters, std::string> read_parameters(std::string_view text);

/// Returns the text of the parameter file at the end of the run. The text has the parameters that were in the file before, and all
/// parameters that LinuxCNC requires, with six decimals.
std::string parameters_text(const StoredParameters& before, const std::function<double(std::uint32_t)>& value);

}  // namespace kadr::linuxcnc
