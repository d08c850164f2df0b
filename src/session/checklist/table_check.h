#pragma once
// Tools and offsets of the tables beside a program: which it calls and they have not, which they have and it never uses.

#include <cstdint>
#include <set>

#include "config/setup.h"
#include "control/state/usage.h"
#include "session/checklist/advice.h"
#include "session/checklist/tool_table.h"

namespace kadr {

/// What the text names, carried out or not: behind a jump or a skipped block stands what another run uses.
struct NamedInText {
  std::set<std::uint32_t> tools, rows;
  bool tools_by_value = false, rows_by_value = false;  // one is an expression: it may be any
};

/// After the run. `use`: of the program's channel.
void check_tables(const ChecklistBasis& basis, const NamedInText& named, const Setup& setup, const ProgramUse& use, Advices& to);

}  // namespace kadr
