// Permanent subprograms: subprograms that are built into the control and have formal parameters (spec/correctors 3). A code with its own
// block format calls each of them.

#include "control/functions/functions.h"

namespace kadr {

/// Sets the formal parameters from the words of the block, as the code's row in the control's file assigns them, and calls the subprogram.
/// A parameter without a word keeps its value (the manual: "the actual path is set by them").
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
