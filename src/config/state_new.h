#pragma once
// Creates a new state file with rows: it is written completely under a temporary name, then renamed if the name is free. Only state_*.cpp
// use it.

#include <string>
#include <vector>

#include "config/state/state_content.h"
#include "config/state/state_file.h"

namespace kadr::state {

/// Creates the file. If it is interrupted, no file with the name `path` exists.
///   returns  on failure, an error sentence: the name exists already, or the file cannot be written
Done make_state(const std::string& path, const std::string& control, const std::vector<StateRow>& rows);

/// Binds a row, whose value has the checksum `sum`, to the statement put_row as the next turn (write of a row, see state_content.h) of
/// `whole`, whose totals include the row already. The row must live until the statement is reset.
void bind_row(sqlite3_stmt* put, const StateRow& row, std::uint64_t sum, Whole& whole);

}  // namespace kadr::state
