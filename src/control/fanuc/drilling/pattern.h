#pragma once
// Positions of holes in a pattern: on a circle (G70), on an arc (G71), along a line (G72) (spec/haas 8.5).

#include <vector>

#include "base/result.h"
#include "base/vec.h"

namespace kadr {
class BlockContext;
struct Call;
}  // namespace kadr

namespace kadr::fanuc {

/// Returns the positions of the holes, in programmed coordinates of the plane, mm. The tool's position is the centre of the circle or arc,
/// or for G72 the first hole.
///   alarms  word_missing: I, L, and K for G71; word_not_integer, value_out_of_range: L
Result<std::vector<Vec2>> pattern_points(const BlockContext& m, const Call& call);

}  // namespace kadr::fanuc
