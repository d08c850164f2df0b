#pragma once
// Drilling cycles G73 … G89 (spec/nct/18): what is kept while the mode is on, and what other functions ask about it.
// The mode is on while group 9 holds a cycle; the code of group 1 stays in force after it.

#include <cstddef>
#include <cstdint>

#include "base/result.h"
#include "base/vec.h"

namespace kadr {
class BlockContext;
class Emitter;
class Interpreter;
struct CodeRow;
}  // namespace kadr

namespace kadr::fanuc {

/// A cycle of group 9 is in force.
bool drilling_on(const BlockContext& m);
/// The row of the code that axis words alone call in this block: the cycle in force, or the code of group 1 (18.0).
std::int16_t motion_row(const BlockContext& m);
/// Axis that drills if the block carries a cycle out, else -1: the one its length offset acts on (15.3, 18.2).
int drills_along(const BlockContext& m);
/// A code has been carried out: one of group 1 deletes the cycle mode (18.0).
void note_code(Interpreter& m, const CodeRow& row, std::int32_t tenth);
/// What the cycle of this block needs from words that act after operation 1: S, M3.
///   alarms  spindle_not_turning
Status check_drilling(const Emitter& m);
/// Operator I after R: R is an increment only in a cycle (5.1). alarms increment_not_allowed
Status check_increment_of_r(const BlockContext& m);

}  // namespace kadr::fanuc
