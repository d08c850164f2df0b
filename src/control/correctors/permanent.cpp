// Permanent subprograms of the control with formal parameters (spec/correctors 3), called by a code with its own block format.

#include "control/functions/functions.h"

namespace kadr {

/// The words of the block set the formal parameters that the code's row in the control's file names; parameters without a word keep their
/// value ("the actual path is set by them").
Status functions::permanent_subprogram(Interpreter& m, const Call& call) {
  const CycleRow& cycle = m.def.cycles[call.row->cycle - std::size_t{1}];
  m.call_where = call.where;
  m.call_text = m.program().shown(m.block->text, m.call_where);
  KADR_TRY(m.flow.call_body(cycle, 1, m.origin, call.where));
  for (const auto& [letter, parameter] : cycle.parameters)
    if (m.has(letter)) m.variables.set_parameter(parameter, m.value(letter));
  return {};
}

}  // namespace kadr
