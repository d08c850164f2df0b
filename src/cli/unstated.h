#pragma once
// What the program has used of a set-up and no set-up states.

#include <optional>
#include <string>

#include "cli/job.h"
#include "session/used_key.h"

namespace kadr::cli {

/// After the run: offsets, work zeros and correctors that were used with the value 0 and stand in no set-up, as one note; its place
/// is that of the first.
std::optional<AlarmReport> unstated(const Control& control, const Job& job);

}  // namespace kadr::cli
