#pragma once
// Patterns of holes: G70 on a circle, G71 on an arc, G72 along a line (spec/haas 8.5).

#include <vector>

#include "base/result.h"
#include "base/vec.h"

namespace kadr {
class BlockContext;
struct Call;
}  // namespace kadr

namespace kadr::fanuc {

/// The holes, programmed coordinates of the plane, mm; the pattern's centre, or first hole of G72, is where the tool stands.
///   alarms  word_missing: I, L, of G71 K; word_not_integer, value_out_of_range: L
Result<std::vector<Vec2>> pattern_points(const BlockContext& m, const Call& call);

}  // namespace kadr::fanuc
