#pragma once
// The file that keeps parameters between runs (spec/linuxcnc 4.4; restore_parameters, save_parameters of the source). Kadr uses a parameter
// file only if the ini file names one. If it names none, LinuxCNC reads and creates `rs274ngc.var`; Kadr does not (INFERRED: nobody named
// that file).

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "base/result.h"

namespace kadr::linuxcnc {

using StoredParameters = std::map<std::uint32_t, double>;

/// Reads lines that consist of a parameter number and a value; skips all other lines.
///   returns  the parameters; or the control's error text if the numbers are out of order or out of range
tl::expected<StoredParameters, std::string> read_parameters(std::string_view text);

/// Returns the text of the parameter file at the end of the run: the parameters that were in the file, and all that the control requires,
/// with six decimals.
std::string parameters_text(const StoredParameters& before, const std::function<double(std::uint32_t)>& value);

}  // namespace kadr::linuxcnc
