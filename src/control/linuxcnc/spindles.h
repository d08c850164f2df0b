#pragma once
// Several spindles, selected by the word `$` (spec/linuxcnc 2.8, 8). The data of the first spindle are in the modal state of the
// interpreter.

#include "action/action.h"
#include "base/result.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::linuxcnc {

/// Converts a spindle number of the word `$`, which counts from 0, to the machine's spindle number, which counts from 1.
std::uint8_t machine_number(int number);
/// Return the direction and the speed that are commanded for a spindle.
SpindleDir direction_of(const BlockContext& m, int number);
double rpm_of(const BlockContext& m, int number);

/// Selects the spindle with which G33, G33.1, G76 or a canned cycle synchronises; the word `$` gives its number. `text`: text of the alarm
/// if the machine has no spindle with this number.
Status take_spindle(BlockContext& m, const char* text, Span where);
/// Returns true if the spindle that take_spindle() has selected is turning.
bool active_spindle_turns(const BlockContext& m);
/// Returns the speed of a spindle in rev/min. It is the block's S if this S is for the spindle, else the speed of an earlier block.
double speed_of_block(const BlockContext& m, int number);
/// Selects the spindle to which G94 to G97 of the block apply. This is the spindle of the word `$`; without `$`, the first one.
Status spindle_of_modes(BlockContext& m);
/// Stops all spindles except the first one (M2, M30).
void stop_other_spindles(Emitter& m);

}  // namespace kadr::linuxcnc
