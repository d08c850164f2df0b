// Finds what is not allowed in a line that the operator has entered (MDI). Used by control/interpreter; tested by tests/panel.py.

#include "control/interpreter.h"

namespace kadr {

/// Returns true if the block is a return of the entered line itself. An entered line has no caller, so the return would end a call of the
/// program, and is refused.
bool Interpreter::returns_from_entered() const {
  if (!flow.in_entered() || flow.depth() > flow.entered_depth()) return false;
  for (std::uint32_t i = 0; i < block->word_count; ++i) {
    const Word& w = block->words[i];
    const std::int32_t row = w.code < 0 ? -1 : def.row_of(w.address, w.code);
    if (row >= 0 && def.codes[static_cast<std::size_t>(row)].function == Function::return_program) return true;
  }
  return false;
}

}  // namespace kadr
