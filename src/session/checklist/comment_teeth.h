#pragma once
// Reads the tool's number of teeth from a comment: "4 FLUTE", "(D8 3FL ENDMILL)", "Z=4".

#include <string_view>

namespace kadr {

/// Returns a number from 1 to 12; 0 if the comment names no number for certain.
int teeth_named(std::string_view comment);

}  // namespace kadr
