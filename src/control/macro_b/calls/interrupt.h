#pragma once
// Interrupt macro: M96 enables it, M97 disables it, and the machine signal CP_MINT calls it between two blocks (spec/nct/23 23.4).

#include "base/result.h"
#include "control/dialect.h"

namespace kadr {
class Interpreter;
struct Call;
}  // namespace kadr

namespace kadr::macro_b {

/// Executes the M codes that N1759 and N1760 assign to the interrupt macro in place of M96 and M97, if N1758 #4 MCD is set.
///   returns  false: the block's code is neither the code of N1759 nor that of N1760
Result<bool> interrupt_code(Interpreter& m, const Call& call);

/// Calls the interrupt macro if M96 has enabled it and the signal CP_MINT requests a call. INFERRED: with parameter bit TPI=0 the macro
/// runs before the next block, with TPI=1 after the present block. While the signal stays on (ELT=0), one block runs between two calls of
/// the macro.
///   returns  true: the macro was called; at the start of a block, that block is executed after the macro
Result<bool> call_interrupt(Interpreter& m, BlockMoment moment);

}  // namespace kadr::macro_b
