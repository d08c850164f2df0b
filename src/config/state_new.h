#pragma once
// A new state file with rows: made beside, whole, and given its name only where there is nothing of that name. Only state_*.cpp use it.

#include <string>
#include <vector>

#include "config/state_content.h"
#include "config/state_file.h"

namespace kadr::state {

/// Interrupted, it leaves nothing of that name.
///   returns  an error sentence: there is something of that name already, or it cannot be written
Done make_state(const std::string& path, const std::string& control, const std::vector<StateRow>& rows);

/// Binds a row, whose value has that checksum, to put_row, as the next turn of the whole, which counts it already. The row must live until
/// the statement is reset.
void bind_row(sqlite3_stmt* put, const StateRow& row, std::uint64_t sum, Whole& whole);

}  // namespace kadr::state
