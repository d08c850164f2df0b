#pragma once
// Lnnmm: a subprogram of the program's sections, or a cycle of the control's file (2С42 6.3, 6.7).

#include "control/interpreter.h"

namespace kadr {

/// nn subprogram or cycle, mm times; two digits alone: once (6.3.3).
///   alarms  too_few_digits, subprogram_missing, cycle_override, cycle_peck, variable_not_set
Status call_section(Interpreter& m, const Call& call);

/// The cycle that `L` of that number calls, or nullptr.
const CycleRow* called_cycle(const ControlDef& def, std::uint32_t number);

/// A zero set in a subprogram is undone on return (last section).
void restore_zero(Emitter& m, const CallFrame& left);

}  // namespace kadr
