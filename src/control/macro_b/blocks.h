#pragma once
// Blocks of the NCT control around the common plan: statements, what calls macros instead of being carried out, data lines,
// what happens after a block (spec/nct/23 23.3, 23.5; 24.1; 12.4).

#include "base/result.h"

namespace kadr {
class Interpreter;
}

namespace kadr::nct {

/// A macro statement (the block's words are evaluated where it needs them).
///   returns  false: IF … THEN holds, the words behind it are to be carried out (23.2.10)
Result<bool> run_statement(Interpreter& m);
/// Values of an NC block: those of expressions are rounded to the last digit of their address (23.1.1), all are in their ranges. What a
/// macro gets as an argument is left alone: it may be any number (23.3).
Status check_values(Interpreter& m);
/// Looks at the evaluated words before they are planned.
///   returns  true: the block is done (a data line, or a macro was called with it)
Result<bool> before_plan(Interpreter& m);
/// Single-block operation stops here: the switch is on, no lock, no G63, not inside a program that counts as one block
/// (23.1.10, 23.3.9, 6.3.4).
bool stops_each_block(const Interpreter& m);
/// Calls that follow the block's motion: words that stand for subprograms, modal macros; the single-block stop.
Status after_block(Interpreter& m);

}  // namespace kadr::nct
