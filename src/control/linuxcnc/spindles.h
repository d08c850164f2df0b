#pragma once
// Several spindles, selected by the word `$` (spec/linuxcnc 2.8, 8). The modal state of the interpreter has the first spindle.

#include "action/action.h"
#include "base/result.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::linuxcnc {

/// Returns the machine's number of a spindle, which counts from 1, for a number of the word `$`, which counts from 0.
std::uint8_t machine_number(int number);
/// Return the direction and the speed that are commanded for a spindle.
SpindleDir direction_of(const BlockContext& m, int number);
double rpm_of(const BlockContext& m, int number);

/// Selects the spindle with which G33, G33.1, G76 or a canned cycle synchronises: that of the word `$`. `text`: text of the alarm if the
/// machine has no such spindle.
Status take_spindle(BlockContext& m, const char* text, Span where);
/// Returns true if the spindle that take_spindle() has selected is turning.
bool active_spindle_turns(const BlockContext& m);
/// Returns the speed of a spindle: the block's S if it is for this spindle, else the speed of an earlier block.
double speed_of_block(const BlockContext& m, int number);
/// Selects the spindle to which G94 to G97 of the block apply: that of the word `$`, or the first one.
Status spindle_of_modes(BlockContext& m);
/// Stops all spindles except the first one (M2, M30).
void stop_other_spindles(Emitter& m);

}  // namespace kadr::linuxcnc
