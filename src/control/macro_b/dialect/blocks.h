#pragma once
// What a control with macros does around the common plan of a block: executes statements, calls macros instead of executing the block,
// and acts after the block (spec/nct/23 23.3, 23.5).

#include "base/result.h"

namespace kadr {
class BlockContext;
class Interpreter;
}  // namespace kadr

namespace kadr::macro_b {

/// Executes the block's macro statement, and evaluates the block's words only where the statement needs them.
///   returns  false: the condition of IF … THEN holds, and the words after THEN are still to be executed (23.2.10)
Result<bool> run_statement(Interpreter& m);
/// Checks the values of an NC block against their ranges, after rounding those of expressions to the last digit of their address (23.1.1).
/// Not for the arguments of a macro, which may be any number (23.3).
Status check_values(BlockContext& m);
/// Starts a block of words: clears what was known of the last block, and restores words that an earlier run of this block removed.
void begin_words(BlockContext& m);
/// Calls a macro with the block's words as arguments: by G66.1, or by a code that is bound to a macro.
///   returns  true: a macro was called
Result<bool> call_with_words(Interpreter& m);
/// Checks that the block has a single G: G is no argument of G65, G66, G66.1, and #10 holds their own number (23.3). alarms illegal_address
Status one_g(const BlockContext& m);
/// Records the block's words for #4101 … (23.1.14).
void note_words(BlockContext& m);
/// True if single-block operation stops at this block: the switch is on, no lock, no G63, not inside a program that counts as one block
/// (23.1.10, 23.3.9, 6.3.4).
bool stops_each_block(const BlockContext& m);
/// Acts after a block of words: the single-block stop, subprograms that its words call, modal macros.
Status end_words(Interpreter& m);

}  // namespace kadr::macro_b
