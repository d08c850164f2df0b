#pragma once
// The steps that a control with macros adds to the execution of a block by the interpreter: macro statements, macro calls in place of the
// block, and steps after the block (spec/nct/23 23.3, 23.5). All controls share the interpreter.

#include "base/result.h"

namespace kadr {
class BlockContext;
class Interpreter;
}  // namespace kadr

namespace kadr::macro_b {

/// Executes the block's macro statement. The block's words are evaluated only if the statement needs their values.
///   returns  false: the condition of IF … THEN is true, and the words after THEN are still to be executed (23.2.10)
Result<bool> run_statement(Interpreter& m);
/// Checks the values of a block's words against the ranges of their addresses. Values of expressions are first rounded to the last digit
/// that the address has (23.1.1). Not used for the arguments of a macro, which may be any number (23.3).
Status check_values(BlockContext& m);
/// Starts a block of words: clears the flags of the previous block, and restores words that an earlier execution of this block removed.
void begin_words(BlockContext& m);
/// Calls a macro with the block's words as arguments: by G66.1, or by a code that is bound to a macro.
///   returns  true: a macro was called
Result<bool> call_with_words(Interpreter& m);
/// Checks that a block with G65, G66 or G66.1 has no further G word. A further G word cannot be an argument, because #10 receives the
/// number of the calling G code (23.3). alarms illegal_address
Status one_g(const BlockContext& m);
/// Records the block's words as the values of #4101 … (23.1.14).
void note_words(BlockContext& m);
/// Returns true if single-block operation stops after this block. Conditions: the switch is on; #3003, #3004 and G63 do not suppress the
/// stop; the block is not inside a program that counts as one block (23.1.10, 23.3.9, 6.3.4).
bool stops_each_block(const BlockContext& m);
/// Completes a block of words: makes the single-block stop, calls the subprograms bound to the block's words, and calls modal macros.
Status end_words(Interpreter& m);

}  // namespace kadr::macro_b
