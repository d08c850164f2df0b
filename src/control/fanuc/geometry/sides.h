#pragma once
// Passes the data of motions and blocks to cutter radius compensation, path/contour/radius_compensation (spec/nct/15 15.5).

#include <optional>

#include "action/action.h"
#include "base/vec.h"
#include "config/function.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::fanuc {

/// Sets side, tool radius and side step of a motion in the plane. The first such motion gets the step: it starts or ends compensation.
void note_side(BlockContext& m, Motion& motion);
/// Handles a block with `/`, whether it is skipped or not: it interrupts compensation if N1337 #4 CBB is 0 (15.5.2).
void note_skip_mark(Emitter& m);
/// True if the block has a new length and increments of zero: the start point shifts by the length, nothing moves (15.3).
bool only_shifts_length(const BlockContext& m);
/// Ends a block with G41, G42 or G40 that did not move in the plane.
void end_side_block(Emitter& m);
/// Returns I, J, K of the plane as a direction, mirrored and rotated like the contour (15.5.1, 15.5.6); nullopt if the block has none.
std::optional<Vec2> plane_direction(const BlockContext& m);

}  // namespace kadr::fanuc
