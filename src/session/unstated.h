#pragma once
// unstated: finds values that the program has used although the set-up does not state them.

#include <optional>
#include <set>
#include <string>

#include "control/control.h"
#include "session/used_key.h"

namespace kadr {

/// Call after the run. Returns one note that lists the offsets, work zeros and correctors that the program used with the value 0 and that
/// the set-up does not state. The location of the note is the first use. Returns nullopt if there are none, or if the set-up disables the
/// note.
///   stated  keys that the set-up states: PlacedSetup::stated
std::optional<AlarmReport> unstated(const Control& control, const ControlDef& def, const Setup& setup, const std::set<std::string>& stated);

}  // namespace kadr
