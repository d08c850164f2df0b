#pragma once
// Describes in words what is in force on the control: modes, tool, offsets, variables. The text is printed when a run begins in
// mid-program.

#include <string>
#include <vector>

#include "action/in_force.h"
#include "config/alarm_texts.h"

namespace kadr {

/// Returns one line for each type of state, which begins with `indent`. Lengths are in mm, angles in degrees. Variables come last, at most
/// `most` of them.
///
///     position X 10 Y 0 Z 5
///     codes    G1 G17 G90 G54 F200 S800 M3 M8
std::string in_force_text(const std::vector<InForce>& all, Lang lang, const std::string& indent = "  ", std::size_t most = 40);

}  // namespace kadr
