#pragma once
// Normalises a code that a user types: Cyrillic or Latin letters, capital or small, with leading zeros.

#include <string>
#include <string_view>
#include <vector>

#include "config/control/control_def.h"

namespace kadr {

/// Returns "м03" as "M3", "g01" as "G1", "G05.10" as "G5.1". Replaces Cyrillic letters by the Latin capitals that look alike (А В С Е Н К
/// М О Р Т Х У) and removes leading and trailing zeros. A text that is not one letter and a number, and a parameter (N0107), keep their
/// digits.
std::string code_asked(std::string_view what);

/// Returns up to three names of the control that are nearest to an unknown code, nearest first. Codes, canned cycles and parameters with
/// the same letter are compared by number; symbols of variables and names of alarms by spelling.
std::vector<std::string> nearest_to(const ControlDef& def, const std::string& what);

}  // namespace kadr
