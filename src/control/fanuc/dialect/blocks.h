#pragma once
// Blocks of words around the common plan: data lines, calls, what is looked at before they are planned, what happens after them
// (spec/nct/23 23.3, 24.1, 12.4; spec/fanuc 1.2, 1.3, 2.1).

#include "base/result.h"

namespace kadr {
class BlockContext;
class Interpreter;
}

namespace kadr::fanuc {

/// Looks at the evaluated words before they are planned.
///   returns  true: the block is done (a data line, or a macro was called with it)
Result<bool> before_plan(Interpreter& m);
/// The block's numbers, as they were read, become what the control counts (spec/fanuc 1.3).
void count_increments(BlockContext& m);
/// Calls that follow the block's motion: words that stand for subprograms, modal macros; the single-block stop.
Status after_block(Interpreter& m);

}  // namespace kadr::fanuc
