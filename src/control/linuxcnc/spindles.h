#pragma once
// Several spindles, chosen by `$` (spec/linuxcnc 2.8, 8). The first one is the spindle of the modal state.

#include "action/action.h"
#include "base/result.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::linuxcnc {

/// The number of a spindle on the machine, which counts from 1; `$` counts from 0.
std::uint8_t machine_number(int number);
/// Direction and speed of a spindle, as commanded.
SpindleDir direction_of(const BlockContext& m, int number);
double rpm_of(const BlockContext& m, int number);

/// Lets `$` choose the spindle that leads G33, G33.1, G76 or a canned cycle; `text`: the alarm if there is no spindle of that number.
Status take_spindle(BlockContext& m, const char* text, Span where);
/// True if the spindle chosen last turns.
bool active_spindle_turns(const BlockContext& m);
/// The speed of a spindle, from S of this block or an earlier one.
double speed_of_block(const BlockContext& m, int number);
/// Lets G94 to G97 choose the spindle too: the first one without `$`.
Status spindle_of_modes(BlockContext& m);
/// Stops all spindles except the first (M2, M30).
void stop_other_spindles(Emitter& m);

}  // namespace kadr::linuxcnc
