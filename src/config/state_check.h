#pragma once
// kadr state: is a state file sound, and what can be read of a damaged one.

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace kadr {

struct StateReport {
  std::string control;              // empty: it cannot be read
  bool checked = true;              // with checksums; false: of an older Kadr, its values cannot be checked
  std::size_t rows = 0;             // sound ones
  std::vector<std::string> faults;  // told; none: the file is sound
};

/// Looks at a copy: the file and its log stay as they are.
///   returns  an error sentence if it is no state, in use by a run, of a newer Kadr, or cannot be read
tl::expected<StateReport, std::string> check_state(const std::string& path);

/// Writes the sound rows into a new file; the old one stays as it is, and so does whatever has the new name.
///   control  whose state it is, if the file no longer says, or wrongly; empty: what the file says
///   returns  what was found, with the number of rows written; an error sentence if nothing was written
tl::expected<StateReport, std::string> recover_state(const std::string& path, const std::string& to, const std::string& control);

/// Whether the file was written without checksums. To be asked before it is opened: closing it takes away the locks of this process.
bool state_is_unchecked(const std::string& path);

}  // namespace kadr
