#pragma once
// Adds to motions and blocks the data that cutter radius compensation needs (path/compensation/radius_compensation; spec/nct/15 15.5).

#include <optional>

#include "action/action.h"
#include "base/vec.h"
#include "config/control/function.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::fanuc {

/// Sets the compensation side, tool radius and side step of a motion. The side step says that the motion starts or ends compensation;
/// only the first motion in the plane after G41, G42 or G40 gets one.
void note_side(BlockContext& m, Motion& motion);
/// Handles a block with the skip character `/`, whether the block is skipped or not. If N1337 #4 CBB is 0, such a block interrupts cutter
/// compensation (15.5.2).
void note_skip_mark(Emitter& m);
/// True if the block commands a new tool length and has only increments of zero (G91). Such a block shifts the start point of the next
/// motion by the length; no axis moves (15.3).
bool only_shifts_length(const BlockContext& m);
/// Completes a block with G41, G42 or G40 that has no motion in the plane: compensation then starts with the next motion, or has ended at
/// the present position.
void end_side_block(Emitter& m);
/// Returns the words I, J, K of the plane as a direction, mirrored and rotated like the contour (15.5.1, 15.5.6); nullopt if there are
/// none.
std::optional<Vec2> plane_direction(const BlockContext& m);

}  // namespace kadr::fanuc
