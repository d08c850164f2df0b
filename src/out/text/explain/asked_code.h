#pragma once
// Normalises a code that a user types: Cyrillic or Latin, capital or small letters, with or without leading zeros.

#include <string>
#include <string_view>
#include <vector>

#include "config/control/control_def.h"

namespace kadr {

/// Returns the normal form of a code: "M3" for "м03", "G1" for "g01", "G5.1" for "G05.10". Cyrillic letters are replaced by the Latin
/// capitals that look alike (А В С Е Н К М О Р Т Х У), and leading and trailing zeros are removed. The digits remain if the text is not one
/// letter and a number, or if it is a parameter (N0107).
std::string code_named(std::string_view what);

/// Returns up to three names of the control that are most similar to an unknown code, the most similar name first. Codes, canned cycles and
/// parameters with the same letter are compared by number; symbols of variables and names of alarms by spelling.
std::vector<std::string> nearest_to(const ControlDef& def, const std::string& what);

}  // namespace kadr
