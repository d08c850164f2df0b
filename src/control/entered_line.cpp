// Checks what a line entered by the operator (MDI) may not do. Used by control/interpreter; tested by tests/panel.py.

#include "control/interpreter.h"

namespace kadr {

/// An entered line has no caller: a return in it must not close the calls that the program has open.
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
