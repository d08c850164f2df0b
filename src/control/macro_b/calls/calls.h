#pragma once
// Macro and subprogram calls: arguments, levels, modal calls, codes and addresses bound to programs (spec/nct/23 23.3, 14.4).

#include "base/result.h"
#include "control/macro_b/macro_b.h"
#include "control/macro_b/programs/programs.h"
#include "lang/block/block.h"

namespace kadr::macro_b {

/// A call that is about to be made.
struct CallRequest {
  ProgramPlace place;
  std::uint32_t name = 0;  // program number, for people
  std::uint32_t times = 1;
  bool macro = false;  // opens a level of locals
  char called_by = 0;  // address that is bound to it, 0: M98, G65 …
  std::int32_t called_code = -1;
};

/// Makes the call: the next block is the program's first.
///   alarms  call_too_deep
Status call(Interpreter& m, const CallRequest& request, const Locals& arguments, Span where);
/// Called after a block that moved, or with a block's words, by the innermost modal call that acts.
Status call_modal(Interpreter& m, const Locals& arguments);
/// L of a call; missing: 1. alarms word_not_integer, value_out_of_range
Result<std::uint32_t> repeats_of(const BlockContext& m);
/// The block's words as arguments (23.3, "Argument assignment"). `skip`: index of the word that calls.
///   alarms  illegal_address (2017)
Status arguments_of(const BlockContext& m, std::uint32_t skip, Locals& to);
/// End of a subprogram or macro, M99 (14.4.3, 14.4.4, 23.4).
Status return_from(Interpreter& m, const Call& code);
/// On after the innermost call although its M99 is missing or faulty: one fault is one alarm.
void leave_call(Interpreter& m);
/// A G, M, T, S, A, B, C word or a letter of N1747… that calls a program instead of being carried out.
///   returns  true: the block's words were arguments of the call
Result<bool> call_by_code(Interpreter& m);
/// The subprogram that a word of this block stands for, after the block (23.3.6–23.3.8).
Status call_pending(Interpreter& m);

}  // namespace kadr::macro_b
