#pragma once
// The steps of the Fanuc family before and after the planning of a block: data lines, macro calls, checks of the words, and calls after the
// motion (spec/nct/23 23.3, 24.1, 12.4; spec/fanuc 1.2, 1.3, 2.1).

#include "base/result.h"

namespace kadr {
class BlockContext;
class Interpreter;
}  // namespace kadr

namespace kadr::fanuc {

/// Checks and prepares the evaluated words of the block before the block is planned.
///   returns  true if nothing of the block remains to be planned: it was a data line, or its words were the arguments of a macro
Result<bool> before_plan(Interpreter& m);
/// Scales numbers without a decimal point to the increments in which the control counts them (spec/fanuc 1.3).
void count_increments(BlockContext& m);
/// Executes the calls that follow the block's motion (words that call subprograms, modal macros), then the single-block stop.
Status after_block(Interpreter& m);

}  // namespace kadr::fanuc
