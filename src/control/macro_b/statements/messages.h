#pragma once
// Messages that a program shows by assigning #3000, #3006, #3106 or #3107 (spec/nct/23 23.1.8), and jumps to block numbers.

#include "base/result.h"
#include "lang/block/block.h"

namespace kadr {
class Emitter;
class Interpreter;
}  // namespace kadr

namespace kadr::macro_b {

/// Executes #3000=n(text), #3006, #3106 or #3107.
///   alarms  program_alarm (code, number, text), message_number
Status message(Emitter& m, const Statement& s);
/// Finds the block with the number `number` in the file being read (23.2.8). alarms block_number_vacant, block_not_found (2125)
Result<Position> block_numbered(Interpreter& m, double number, Span where);
Status go_to_block(Interpreter& m, double number, Span where);
/// Does the same as go_to_block(), but for M99 P of a main program: a jump back starts another pass of the program (14.4.4).
Status go_to_block_again(Interpreter& m, double number, Span where);

}  // namespace kadr::macro_b
