#pragma once
// What a person types for a code: either alphabet, either case, zeros in front.

#include <string>
#include <string_view>
#include <vector>

#include "config/control_def.h"

namespace kadr {

/// "м03" → "M3", "g01" → "G1", "G05.10" → "G5.1": capital Latin letters for the Cyrillic ones that look alike (А В С Е Н К М О Р Т Х У),
/// no zeros that say nothing. What is no letter with a number keeps its digits.
std::string code_asked(std::string_view what);

/// Up to three names of the control that are nearest to an unknown code, nearest first: codes, cycles and parameters of its letter
/// by their number; symbols of variables and names of alarms by their spelling.
std::vector<std::string> nearest_to(const ControlDef& def, const std::string& what);

}  // namespace kadr
