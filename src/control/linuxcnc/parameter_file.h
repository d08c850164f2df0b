#pragma once
// The file that keeps parameters between runs (spec/linuxcnc 4.4; restore_parameters, save_parameters of the source). Kadr uses it only if
// the ini file names it. Without a name LinuxCNC reads and creates `rs274ngc.var`; Kadr does not (INFERRED: nobody named that file).

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "base/result.h"

namespace kadr::linuxcnc {

using StoredParameters = std::map<std::uint32_t, double>;

/// Reads lines of a number and a value; skips others.
///   returns  the parameters, else the control's error text: out of order, out of range
tl::expected<StoredParameters, std::string> read_parameters(std::string_view text);

/// The text of the file at the end of the run: the parameters that were in it, and all that the control needs; six decimals.
std::string parameters_text(const StoredParameters& before, const std::function<double(std::uint32_t)>& value);

}  // namespace kadr::linuxcnc
