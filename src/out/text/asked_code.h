#pragma once
// Reads a code as a person types it: in either alphabet, in either case, with leading zeros.

#include <string>
#include <string_view>
#include <vector>

#include "config/control_def.h"

namespace kadr {

/// "м03" → "M3", "g01" → "G1", "G05.10" → "G5.1". Replaces Cyrillic letters by the capital Latin letters that look alike (А В С Е Н К М О Р
/// Т Х У) and drops zeros without meaning. A text other than a letter and a number keeps its digits.
std::string code_asked(std::string_view what);

/// Returns up to three names of the control that are nearest to an unknown code, nearest first: codes, canned cycles and parameters with
/// its letter by their number; symbols of variables and names of alarms by their spelling.
std::vector<std::string> nearest_to(const ControlDef& def, const std::string& what);

}  // namespace kadr
