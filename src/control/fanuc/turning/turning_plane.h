#pragma once
// The plane of a turning cycle (spec/nct/19): the tool's position in the plane, motions in the plane, and the words of the two axes of the
// plane.

#include <array>
#include <cstddef>

#include "action/action.h"
#include "base/result.h"
#include "base/vec.h"

namespace kadr {
class BlockContext;
class Emitter;
struct Word;
}  // namespace kadr

namespace kadr::fanuc {

/// Returns the tool's position in the plane, in programmed coordinates, mm.
Vec2 plane_point(const BlockContext& m);
/// Adds a straight motion in the plane to the point `to`. The motion names only the axes whose coordinate changes; if no coordinate
/// changes, nothing is added.
Status go(Emitter& m, MotionKind kind, Vec2 to);
/// Marks the end of a pass of the cycle. In single-block operation the machine then stops (19.B, INFERRED).
void end_pass(Emitter& m);

/// Returns the index of a word's axis in the plane: 0 for the first axis, 1 for the second; 2 if the axis is not in the plane.
std::size_t place_in_plane(const BlockContext& m, const Word& w);
/// The target that the cycle's axis words give in the plane, Cartesian. `given`: which of the two axes have a word in the block.
///   alarms  illegal_address: an axis that is not in the plane
struct PlaneTarget {
  Vec2 to;
  std::array<bool, 2> given{};
};
Result<PlaneTarget> plane_target(BlockContext& m);
/// Returns the letter of the plane's first (0) or second (1) axis.
char letter_of(const BlockContext& m, std::size_t which);

}  // namespace kadr::fanuc
