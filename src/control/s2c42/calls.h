#pragma once
// Lnnmm of the 2С42: subprograms (6.3) and the cycles L81…L89 (6.7).

#include "control/machinery.h"

namespace kadr::s2c42 {

/// nn subprogram or cycle, mm times; two digits alone: once (6.3.3).
///   alarms  too_few_digits, subprogram_missing, cycle_override, cycle_peck, variable_not_set
Status call(Machinery& m, const Call& call);

/// The first block of a subprogram of the program: one whose number is a cycle's cannot be called (6.7.1).
void note_subprogram(Machinery& m);

/// A zero set in a subprogram is undone on return (last section).
void restore_zero(Machinery& m, const CallFrame& left);

}  // namespace kadr::s2c42
