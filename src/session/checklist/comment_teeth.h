#pragma once
// Reads the tool's number of teeth from a comment: "4 FLUTE", "(D8 3FL ENDMILL)", "Z=4".

#include <string_view>

namespace kadr {

/// Returns the number of teeth, from 1 to 12; 0 if the comment does not clearly state it.
int teeth_named(std::string_view comment);

}  // namespace kadr
