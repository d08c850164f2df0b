#pragma once
// Several spindles, selected by the word `$` (spec/linuxcnc 2.8, 8). The modal state of the interpreter has the first spindle.

#include "action/action.h"
#include "base/result.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::linuxcnc {

/// Converts a number of the word `$`, which counts spindles from 0, to the machine's number, which counts from 1.
std::uint8_t machine_number(int number);
/// Return the commanded direction and speed of a spindle.
SpindleDir direction_of(const BlockContext& m, int number);
double rpm_of(const BlockContext& m, int number);

/// Selects by the word `$` the spindle with which G33, G33.1, G76 or a canned cycle synchronises. `text`: text of the alarm if the machine
/// has no spindle of that number.
Status take_spindle(BlockContext& m, const char* text, Span where);
/// True if the spindle that take_spindle() selected last is turning.
bool active_spindle_turns(const BlockContext& m);
/// Returns the speed of a spindle: S of this block if it applies to the spindle, else the speed from an earlier block.
double speed_of_block(const BlockContext& m, int number);
/// Selects the spindle in a block with G94 to G97: the spindle of the word `$`, or the first spindle if there is no `$`.
Status spindle_of_modes(BlockContext& m);
/// Stops all spindles except the first (M2, M30).
void stop_other_spindles(Emitter& m);

}  // namespace kadr::linuxcnc
