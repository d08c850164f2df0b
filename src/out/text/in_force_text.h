#pragma once
// Describes in words what is in force: the sheet that a run from mid-program begins with.

#include <string>
#include <vector>

#include "action/in_force.h"
#include "config/alarm_texts.h"

namespace kadr {

/// Returns one line for each kind of thing, begun by `indent`; lengths in mm, angles in degrees. Variables come last, `most` of them at
/// most.
///
///     position X 10 Y 0 Z 5
///     codes    G1 G17 G90 G54 F200 S800 M3 M8
std::string in_force_text(const std::vector<InForce>& all, Lang lang, const std::string& indent = "  ", std::size_t most = 40);

}  // namespace kadr
