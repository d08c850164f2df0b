#pragma once
// Drilling cycles G73 … G89 (spec/nct/18): the data stored while a cycle is in force, and queries about these data for other functions. The
// cycle mode is on while modal group 9 has a cycle in force; the code of group 1 remains in force after the cycle ends.

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

/// Returns true if a cycle of group 9 is in force.
bool drilling_on(const BlockContext& m);
/// Returns the index in ControlDef::codes of the code that a block with axis words only executes: the cycle in force, or else the code of
/// group 1 (18.0).
std::int16_t motion_row(const BlockContext& m);
/// Returns the drilling axis if the block executes a cycle, or -1. A length offset acts on this axis (15.3, 18.2).
int drills_along(const BlockContext& m);
/// Called after each executed code: a code of group 1 ends the cycle mode (18.0).
void note_code(Interpreter& m, const CodeRow& row, std::int32_t tenth);
/// Checks that the spindle turns if the cycle of this block needs it. S and M3 of the block take effect after operation 1 of the cycle, the
/// motion over the hole.
///   alarms  spindle_not_turning
Status check_drilling(const Emitter& m);
/// Checks the operator I (incremental value) of an R word, which is permitted only in a cycle (5.1). alarms increment_not_allowed
Status check_increment_of_r(const BlockContext& m);

}  // namespace kadr::fanuc
