// What a faulty block has changed is taken back (design.md 4): for Interpreter::take_back, which does the same for what all controls have.

#include "control/interpreter.h"
#include "control/nct/nct.h"

namespace kadr::nct {

void Nct::begin_block(Emitter& m) {
  m.journal.keep<MotionMemory>(state);
  before_.all = false;
}

void Nct::keep_all() {
  if (before_.all) return;
  before_ = {true, state, variables.depth(), repeated_arguments.size()};
}

void Nct::take_back(BlockContext&) {
  if (!before_.all) return;
  state = before_.state;
  while (variables.depth() > before_.levels) variables.close_level();
  if (repeated_arguments.size() > before_.repeated_arguments) repeated_arguments.resize(before_.repeated_arguments);
}

void Nct::taken_back(Emitter& m) {
  refresh_settings(m);
  if (m.keeps_state()) follow_from_here(m);
}

}  // namespace kadr::nct
