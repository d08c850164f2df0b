#pragma once
// What cutter radius compensation (path/contour/radius_compensation) is told of motions and blocks (spec/nct/15 15.5).

#include <optional>

#include "action/action.h"
#include "base/vec.h"
#include "config/function.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::fanuc {

/// Side, radius and step of a motion in the plane; the step is taken by the first one.
void note_side(BlockContext& m, Motion& motion);
/// A block with `/`: whether it is skipped or not, it interrupts compensation where N1337 #4 CBB is 0 (15.5.2).
void note_skip_mark(Emitter& m);
/// Increments of zero beside a new length: the start point is shifted by it, nothing moves (15.3).
bool only_shifts_length(const BlockContext& m);
/// G41, G42, G40 in a block that did not move in the plane.
void end_side_block(Emitter& m);
/// I, J, K of the plane as a direction, mirrored and turned as the contour is (15.5.1, 15.5.6); nothing if none stands in the block.
std::optional<Vec2> plane_direction(const BlockContext& m);

}  // namespace kadr::fanuc
