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

/// Sets the compensation side, tool radius and side step of a motion. The side step of a motion tells whether the motion starts or ends
/// compensation; only the first motion in the plane after G41, G42 or G40 has one.
void note_side(BlockContext& m, Motion& motion);
/// Processes the skip character `/` of a block, whether or not the block is skipped. If N1337 #4 CBB is 0, the block interrupts cutter
/// compensation (15.5.2).
void note_skip_mark(Emitter& m);
/// Returns true if the block commands a new tool length and has only increments of zero (G91). Such a block moves no axis; it shifts the
/// start point of the next motion by the length (15.3).
bool only_shifts_length(const BlockContext& m);
/// Completes a block with G41, G42 or G40 that has no motion in the plane. After G41 or G42, compensation starts with the next motion;
/// after G40, compensation has ended at the present position.
void end_side_block(Emitter& m);
/// Begins a turning cycle. With G41 or G42 in force, the tool is then at its programmed point, and compensation starts again with the next
/// compensated motion (spec/fanuc-t 9.11). Otherwise nothing changes.
void restart_side(Emitter& m);
/// The same for a cycle whose own motions are not compensated: threads, pecks, and passes along a figure that is compensated already
/// (spec/fanuc-t 7.4, 9.11).
void suspend_side(Emitter& m);
/// Returns the words I, J, K of the plane as a direction, mirrored and rotated like the contour (15.5.1, 15.5.6); nullopt if the block has
/// none of these words.
std::optional<Vec2> plane_direction(const BlockContext& m);

}  // namespace kadr::fanuc
