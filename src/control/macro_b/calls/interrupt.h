#pragma once
// Interrupt macro: M96, M97, the signal CP_MINT (spec/nct/23 23.4).

#include "base/result.h"
#include "control/dialect.h"

namespace kadr {
class Interpreter;
struct Call;
}  // namespace kadr

namespace kadr::macro_b {

/// With N1758 #4 MCD the codes of N1759 and N1760 do what M96 and M97 do.
///   returns  true: it was such a code
Result<bool> interrupt_code(Interpreter& m, const Call& call);

/// Calls the interrupt macro if it is enabled and the signal asks for it. INFERRED: with TPI=0 before the block that would begin,
/// with TPI=1 after the block; with a signal that stays (ELT=0) the interrupted program goes on by a block between two calls.
///   returns  true: it was called; at the start of a block: instead of the block, which follows the macro
Result<bool> call_interrupt(Interpreter& m, BlockMoment moment);

}  // namespace kadr::macro_b
