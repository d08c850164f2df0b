#pragma once
// Lnnmm: calls a subprogram of the program's sections, or a canned cycle of the control's file (2С42 6.3, 6.7).

#include "control/interpreter.h"

namespace kadr {

/// Executes a word Lnnmm: calls the subprogram or cycle nn, mm times. If L has only two digits, it is called once (2С42 6.3.3).
///   alarms  too_few_digits, subprogram_missing, cycle_override, cycle_peck, variable_not_set
Status call_section(Interpreter& m, const Call& call);

/// Returns the canned cycle that a word L with this number calls; nullptr if it calls no canned cycle.
const CycleRow* called_cycle(const ControlDef& def, std::uint32_t number);

/// Restores, on return, the caller's work offset if the subprogram has changed the work offset (2С42, last section).
void restore_work_offset(Emitter& m, const CallFrame& left);

}  // namespace kadr
