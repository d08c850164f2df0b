#pragma once
// What is in force, in words: the sheet that a run in mid program begins with.

#include <string>
#include <vector>

#include "action/in_force.h"
#include "config/alarm_texts.h"

namespace kadr {

/// A line a kind of thing, each begun by `indent`; lengths mm, angles degrees. Variables stand last; `most` of them.
///
///     position X 10 Y 0 Z 5
///     codes    G1 G17 G90 G54 F200 S800 M3 M8
std::string in_force_text(const std::vector<InForce>& all, Lang lang, const std::string& indent = "  ", std::size_t most = 40);

}  // namespace kadr
