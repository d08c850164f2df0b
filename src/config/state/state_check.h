#pragma once
// The functions of `kadr state`: check a state file, and recover the readable rows of a damaged file.

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace kadr {

struct StateReport {
  std::string control;   // id of the control; empty if the file does not state it readably
  bool checked = true;   // true if the file has checksums; if false, an older Kadr wrote the file, and its values cannot be checked
  std::size_t rows = 0;  // number of valid rows
  std::vector<std::string> faults;  // the faults of the file as sentences; empty: the file is valid
};

/// Checks a copy of the state file, so that the file and its log are not changed.
///   returns  on failure, an error sentence: not a state file, in use by a run, written by a newer Kadr, or unreadable
tl::expected<StateReport, std::string> check_state(const std::string& path);

/// Writes the valid rows to a new file. The old file is not changed, and an existing file is not overwritten.
///   control  the control of the state, if the file does not state it readably or correctly; empty: the control that the file states
///   returns  the report, with the number of rows written; an error sentence if nothing was written
tl::expected<StateReport, std::string> recover_state(const std::string& path, const std::string& to, const std::string& control);

/// Returns true if the file was written without checksums. Call this function before the file is opened, because it closes the file, which
/// releases the locks of this process.
bool state_is_unchecked(const std::string& path);

}  // namespace kadr
