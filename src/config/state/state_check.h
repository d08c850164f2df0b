#pragma once
// kadr state: checks a state file, and recovers what is readable in a damaged one.

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace kadr {

struct StateReport {
  std::string control;              // id of the control; empty if it cannot be read
  bool checked = true;              // the file has checksums; false: an older Kadr wrote it, so its values cannot be checked
  std::size_t rows = 0;             // number of valid rows
  std::vector<std::string> faults;  // faults as sentences; empty: the file is valid
};

/// Checks a copy, so that the file and its log are not changed.
///   returns  on failure, an error sentence: not a state file, in use by a run, written by a newer Kadr, or unreadable
tl::expected<StateReport, std::string> check_state(const std::string& path);

/// Writes the valid rows to a new file. The old file is not changed, and an existing file is not replaced.
///   control  the control of the state, if the file does not say it any more, or wrongly; empty: as the file says
///   returns  what was found, with the number of rows written; an error sentence if nothing was written
tl::expected<StateReport, std::string> recover_state(const std::string& path, const std::string& to, const std::string& control);

/// Returns true if the file was written without checksums. Call it before the file is opened: closing the file here releases the locks of
/// this process.
bool state_is_unchecked(const std::string& path);

}  // namespace kadr
