#pragma once
// The plane of a turning cycle (spec/nct/19): where the tool stands in it, motions along it, the words of its two axes.

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

/// A point of the plane where the tool stands, programmed.
Vec2 plane_point(const BlockContext& m);
/// A straight motion in the plane; only of the axes that change.
Status go(Emitter& m, MotionKind kind, Vec2 to);
/// A pass is over: the stop of single-block operation (19.B, INFERRED).
void end_pass(Emitter& m);

/// Of an axis word: 0 or 1, first or second axis of the plane; 2: not in it.
std::size_t place_in_plane(const BlockContext& m, const Word& w);
/// Target of the cycle's axis words in the plane, which are Cartesian. `given`: which of the two stand in the block.
///   alarms  illegal_address: an axis that is not in the plane
struct PlaneTarget {
  Vec2 to;
  std::array<bool, 2> given{};
};
Result<PlaneTarget> plane_target(BlockContext& m);
/// Letter of the plane's first (0) or second (1) axis.
char letter_of(const BlockContext& m, std::size_t which);

}  // namespace kadr::fanuc
