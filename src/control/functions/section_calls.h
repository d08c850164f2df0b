#pragma once
// Lnnmm: calls a subprogram of the program's sections, or a canned cycle of the control's file (2С42 6.3, 6.7).

#include "control/interpreter.h"

namespace kadr {

/// Calls subprogram or cycle nn, mm times; with only two digits, once (6.3.3).
///   alarms  too_few_digits, subprogram_missing, cycle_override, cycle_peck, variable_not_set
Status call_section(Interpreter& m, const Call& call);

/// Returns the canned cycle that `L` with this number calls, or nullptr.
const CycleRow* called_cycle(const ControlDef& def, std::uint32_t number);

/// Restores, on return, a work offset that a subprogram has changed (last section).
void restore_zero(Emitter& m, const CallFrame& left);

}  // namespace kadr
