#pragma once
// Compares the tool and offset tables with the program: which tools of the program the tables lack, and which rows of the tables the
// program never uses.

#include <cstdint>
#include <set>

#include "config/setup/setup.h"
#include "control/state/usage.h"
#include "session/checklist/advice.h"
#include "session/checklist/tool_table.h"

namespace kadr {

/// The tool and offset numbers that occur in the text, executed or not: another run may use what is after a jump or in a skipped block.
struct NamedInText {
  std::set<std::uint32_t> tools, rows;
  bool tools_by_value = false, rows_by_value = false;  // a tool or offset number is an expression, so it may be any number
};

/// Call after the run. `use`: the values that the channel of the program has used.
void check_tables(const ChecklistBasis& basis, const NamedInText& named, const Setup& setup, const ProgramUse& use, Advices& to);

}  // namespace kadr
