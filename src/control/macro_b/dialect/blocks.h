#pragma once
// Blocks of a control with macros around the common plan: statements, what calls macros instead of being carried out, what happens after a
// block (spec/nct/23 23.3, 23.5).

#include "base/result.h"

namespace kadr {
class BlockContext;
class Interpreter;
}  // namespace kadr

namespace kadr::macro_b {

/// A macro statement (the block's words are evaluated where it needs them).
///   returns  false: IF … THEN holds, the words behind it are to be carried out (23.2.10)
Result<bool> run_statement(Interpreter& m);
/// Values of an NC block: those of expressions are rounded to the last digit of their address (23.1.1), all are in their ranges. What a
/// macro gets as an argument is left alone: it may be any number (23.3).
Status check_values(BlockContext& m);
/// A block of words begins: nothing is known of it; words that an earlier run of it took away are there again.
void begin_words(BlockContext& m);
/// The block's words are arguments of a macro: of G66.1, or of a code that is bound to one.
///   returns  true: it was called
Result<bool> call_with_words(Interpreter& m);
/// G is no argument of G65, G66, G66.1: #10 holds their own number (23.3). alarms illegal_address
Status one_g(const BlockContext& m);
/// What #4101 … give (23.1.14).
void note_words(BlockContext& m);
/// Single-block operation stops here: the switch is on, no lock, no G63, not inside a program that counts as one block
/// (23.1.10, 23.3.9, 6.3.4).
bool stops_each_block(const BlockContext& m);
/// After a block of words: the single-block stop; words that stand for subprograms, modal macros.
Status end_words(Interpreter& m);

}  // namespace kadr::macro_b
