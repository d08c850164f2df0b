#pragma once
// The file that keeps parameters from run to run (spec/linuxcnc 4.4; restore_parameters, save_parameters of the source). Only where the ini
// file names it: LinuxCNC takes and makes `rs274ngc.var` without one, which Kadr does not (INFERRED: a file that nobody named).

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "base/result.h"

namespace kadr::linuxcnc {

using StoredParameters = std::map<std::uint32_t, double>;

/// Lines of a number and a value; others are passed over.
///   returns  the control's sentence: out of order, out of range
tl::expected<StoredParameters, std::string> read_parameters(std::string_view text);

/// What it becomes at the end: those that were in it, and all that the control needs; six decimals.
std::string parameters_text(const StoredParameters& before, const std::function<double(std::uint32_t)>& value);

}  // namespace kadr::linuxcnc
