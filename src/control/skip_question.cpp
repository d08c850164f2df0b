// Decides whether a skip switch skips a block, and whether the operator is asked first (spec/gost 2). Used by control/interpreter; tested
// by tests/cases/gost/skip.cases.

#include <algorithm>

#include "control/interpreter.h"

namespace kadr {

/// Asks the operator whether the skip switch applies to the block, if the set-up has answers of an operator. The block is read again when
/// the answer is known (spec/gost 2). INFERRED: the question shown is the text of the block.
bool Interpreter::asks_to_skip() {
  if (skip_answers.empty() || skips_it || !is_skipped()) return false;
  skips_it = skip_answers[std::min(answers_used++, skip_answers.size() - 1)];
  emit(Message{std::string(block->text) + " ?", -1, true});
  phase_ = RunPhase::same_block;
  return true;
}

bool Interpreter::is_skipped() const {
  return block->skip != 0 && skip_switches[block->skip % skip_switches.size()] && skips_it.value_or(true);
}

}  // namespace kadr
