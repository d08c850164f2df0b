#pragma once
// Macro and subprogram calls: arguments, levels, modal calls, codes and addresses bound to programs (spec/nct/23 23.3, 14.4).

#include "base/result.h"
#include "control/macro_b/macro_b.h"
#include "control/macro_b/programs/programs.h"
#include "lang/block/block.h"

namespace kadr::macro_b {

/// A call of a macro or subprogram that is to be executed.
struct CallRequest {
  ProgramLocation place;
  std::uint32_t name = 0;  // program number in messages about the call
  std::uint32_t times = 1;
  bool macro = false;  // true: the call opens a new level of local variables
  char called_by = 0;  // address of the word that parameters bind to the program; 0 for a call by M98, G65 …
  std::int32_t called_code = -1;
};

/// Executes the call: the next block to be read is the first block of the called program.
///   alarms  call_too_deep
Status call(Interpreter& m, const CallRequest& request, const Locals& arguments, Span where);
/// Executes the innermost modal call in force: a call by G66 after a block that moved, or by G66.1 with the block's words as arguments.
Status call_modal(Interpreter& m, const Locals& arguments);
/// Returns the L word of a call, the number of repetitions; 1 if L is missing. alarms word_not_integer, value_out_of_range
Result<std::uint32_t> repeats_of(const BlockContext& m);
/// Converts the block's words into macro arguments (23.3, "Argument assignment"). `skip`: index of the word that makes the call; this word
/// is not an argument.
///   alarms  illegal_address (2017)
Status arguments_of(const BlockContext& m, std::uint32_t skip, Locals& to);
/// M99: ends a subprogram or macro (14.4.3, 14.4.4, 23.4).
Status return_from(Interpreter& m, const Call& code);
/// Ends the innermost call although the M99 of the called program is missing or faulty. Without this, one fault would cause several alarms.
void leave_call(Interpreter& m);
/// Executes a call by a word that parameters bind to a program: G, M, T, S, A, B, C, or a letter of N1747….
///   returns  true: the block's words were the arguments of the call, so nothing of the block remains to be executed
Result<bool> call_by_code(Interpreter& m);
/// Calls, after the block, the subprograms that parameters bind to words of the block (23.3.6–23.3.8).
Status call_pending(Interpreter& m);

}  // namespace kadr::macro_b
