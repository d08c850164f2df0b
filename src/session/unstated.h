#pragma once
// unstated: values that the program has used and no set-up states.

#include <optional>
#include <set>
#include <string>

#include "control/control.h"
#include "session/used_key.h"

namespace kadr {

/// After the run: one note that lists the offsets, work zeros and correctors that were used with the value 0 and that no set-up states; its
/// location is that of the first use. Returns nullopt if there are none, or the set-up disables the note.
///   stated  PlacedSetup::stated
std::optional<AlarmReport> unstated(const Control& control, const ControlDef& def, const Setup& setup, const std::set<std::string>& stated);

}  // namespace kadr
