#pragma once
// What the program has used of a set-up and no set-up states.

#include <optional>
#include <set>
#include <string>

#include "control/control.h"
#include "session/used_key.h"

namespace kadr {

/// After the run: offsets, work zeros and correctors that were used with the value 0 and stand in no set-up, as one note; its place
/// is that of the first. Nothing where the set-up disables it.
///   stated  PlacedSetup::stated
std::optional<AlarmReport> unstated(const Control& control, const ControlDef& def, const Setup& setup, const std::set<std::string>& stated);

}  // namespace kadr
