#pragma once
// Several spindles, chosen by `$` (spec/linuxcnc 2.8, 8). The first one is that of the modal state.

#include "action/action.h"
#include "base/result.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::linuxcnc {

/// The machine counts its spindles from 1, `$` from 0.
std::uint8_t machine_number(int number);
/// A spindle as it was commanded.
SpindleDir direction_of(const BlockContext& m, int number);
double rpm_of(const BlockContext& m, int number);

/// G33, G33.1, G76, cycles: `$` chooses the spindle that leads; `text`: what is said of a number there is no spindle of.
Status take_spindle(BlockContext& m, const char* text, Span where);
/// Does the one turn that was chosen last?
bool active_spindle_turns(const BlockContext& m);
/// What S of the block, or one before, has told it.
double speed_of_block(const BlockContext& m, int number);
/// G94 to G97 choose the spindle too, the first one without `$`.
Status spindle_of_modes(BlockContext& m);
/// All but the first one stand (M2, M30).
void stop_other_spindles(Emitter& m);

}  // namespace kadr::linuxcnc
