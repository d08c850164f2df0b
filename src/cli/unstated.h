#pragma once
// What the program has used of a set-up and no set-up states.

#include <optional>
#include <string>

#include "cli/job.h"
#include "config/setup_names.h"

namespace kadr::cli {

/// The key of a set-up that states it ("offsets.1.length", "work_offsets.G54"), and how the program calls it ("H1", "G54").
struct UsedKey {
  std::string key;
  std::string word;
};
UsedKey used_key(const Use& use, const ControlDef& def);

/// After the run: offsets, work zeros and correctors that were used with the value 0 and stand in no set-up, as one note; its place
/// is that of the first.
std::optional<AlarmReport> unstated(const Control& control, const Job& job);

}  // namespace kadr::cli
