#pragma once
// Compares the tool and offset tables with the program: which tools it calls that they lack, and which of theirs it never uses.

#include <cstdint>
#include <set>

#include "config/setup.h"
#include "control/state/usage.h"
#include "session/checklist/advice.h"
#include "session/checklist/tool_table.h"

namespace kadr {

/// The numbers that the text names, executed or not: after a jump or in a skipped block is what another run uses.
struct NamedInText {
  std::set<std::uint32_t> tools, rows;
  bool tools_by_value = false, rows_by_value = false;  // one number is an expression, so any may be meant
};

/// Call after the run. `use`: of the program's channel.
void check_tables(const ChecklistBasis& basis, const NamedInText& named, const Setup& setup, const ProgramUse& use, Advices& to);

}  // namespace kadr
