#pragma once
// Interrupt macro: M96, M97, the signal CP_MINT (spec/nct/23 23.4).

#include "base/result.h"
#include "control/dialect.h"

namespace kadr {
class Interpreter;
struct Call;
}  // namespace kadr

namespace kadr::macro_b {

/// Executes the codes of N1759 and N1760, which do what M96 and M97 do if N1758 #4 MCD is set.
///   returns  false: the block's code is neither of them
Result<bool> interrupt_code(Interpreter& m, const Call& call);

/// Calls the interrupt macro if it is enabled and the signal requests it. INFERRED: with TPI=0 before the block that would start,
/// with TPI=1 after the block; while the signal stays on (ELT=0) the interrupted program runs one block between two calls.
///   returns  true: the macro was called; at the start of a block, that block is executed after the macro
Result<bool> call_interrupt(Interpreter& m, BlockMoment moment);

}  // namespace kadr::macro_b
