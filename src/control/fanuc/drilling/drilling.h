#pragma once
// Drilling cycles G73 … G89 (spec/nct/18): the data kept while a cycle is in force, and what other functions ask about it. The mode is on
// while group 9 holds a cycle; the code of group 1 remains in force after the cycle ends.

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

/// True if a cycle of group 9 is in force.
bool drilling_on(const BlockContext& m);
/// Returns the row of the code that axis words alone execute in this block: the cycle in force, or the code of group 1 (18.0).
std::int16_t motion_row(const BlockContext& m);
/// Returns the drilling axis if the block executes a cycle, else -1. A length offset acts on this axis (15.3, 18.2).
int drills_along(const BlockContext& m);
/// Called after each executed code: a code of group 1 ends the cycle mode (18.0).
void note_code(Interpreter& m, const CodeRow& row, std::int32_t tenth);
/// Checks what the cycle of this block needs from words that act after operation 1: S, M3.
///   alarms  spindle_not_turning
Status check_drilling(const Emitter& m);
/// Checks the operator I after R: R can be an increment only in a cycle (5.1). alarms increment_not_allowed
Status check_increment_of_r(const BlockContext& m);

}  // namespace kadr::fanuc
