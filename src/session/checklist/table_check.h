#pragma once
// Compares the tool and offset tables with the program. The findings are tools of the program that the tables lack, and table rows that the
// program never uses.

#include <cstdint>
#include <set>

#include "config/setup/setup.h"
#include "control/state/usage.h"
#include "session/checklist/advice.h"
#include "session/checklist/tool_table.h"

namespace kadr {

/// The tool and offset numbers in the text of the program, including blocks that this run did not execute: another run may execute blocks
/// after a jump or with a slash.
struct NamedInText {
  std::set<std::uint32_t> tools, rows;
  bool tools_by_value = false, rows_by_value = false;  // true: some tool or offset number is an expression, so it may be any number
};

/// Reports the findings. Call this function after the run. `use`: the values that the program of the channel has used.
void check_tables(const ChecklistBasis& basis, const NamedInText& named, const Setup& setup, const ProgramUse& use, Advices& to);

}  // namespace kadr
