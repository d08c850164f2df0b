#pragma once
// Creates a new state file with rows. The file is written completely under a temporary name, then renamed, if no file with the new name
// exists. Only state_*.cpp use it.

#include <string>
#include <vector>

#include "config/state/state_content.h"
#include "config/state/state_file.h"

namespace kadr::state {

/// Creates the file. If the process is interrupted, no incomplete file with the name `path` exists.
///   returns  on failure, an error sentence: the name exists already, or the file cannot be written
Done make_state(const std::string& path, const std::string& control, const std::vector<StateRow>& rows);

/// Prepares the SQL statement `put` to write a row of the state file. This counts as the next turn (a turn is one write of a row, see
/// state_content.h). `sum` is the checksum of the row's value. The totals in `whole` must include the row already. The row must exist until
/// the statement is reset.
void bind_row(sqlite3_stmt* put, const StateRow& row, std::uint64_t sum, Whole& whole);

}  // namespace kadr::state
