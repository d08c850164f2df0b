#pragma once
// unstated: finds values that the program has used although the set-up does not state them.

#include <optional>
#include <set>
#include <string>

#include "control/control.h"
#include "session/used_key.h"

namespace kadr {

/// Returns one note that lists the offsets, work offsets and correctors that the program used although the set-up does not state them, so
/// that their value was 0. The location of the note is the first use. Returns nullopt if the list is empty, or if the set-up disables the
/// note. Call this function after the run.
///   stated  names of the keys that the set-up states: PlacedSetup::stated
std::optional<AlarmReport> unstated(const Control& control, const ControlDef& def, const Setup& setup, const std::set<std::string>& stated);

}  // namespace kadr
