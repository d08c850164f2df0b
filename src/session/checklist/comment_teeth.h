#pragma once
// Reads the number of teeth that a comment names: "4 FLUTE", "(D8 3FL ENDMILL)", "Z=4".

#include <string_view>

namespace kadr {

/// returns  1 to 12; 0 if no number is certain
int teeth_named(std::string_view comment);

}  // namespace kadr
