// Undoes what a block has written. Used by Interpreter::undo_block; tested by tests/control/journal_test.cpp.

#include "control/state/journal.h"

namespace kadr {

void Journal::undo() {
  while (used_ != 0) {
    Change last{};
    used_ -= sizeof last;
    std::memcpy(&last, bytes_.data() + used_, sizeof last);
    if (last.cell == nullptr) {
      undos_[last.size]();
      continue;
    }
    used_ -= rounded(last.size);
    std::memcpy(last.cell, bytes_.data() + used_, last.size);
  }
  undos_.clear();
}

}  // namespace kadr
