#pragma once
// The axis along which a drilling cycle drills, and the word that gives the bottom of the hole (spec/nct/18.0, spec/haas-st 7).

#include "base/result.h"

namespace kadr {
class BlockContext;
struct CodeRow;
struct Word;
}  // namespace kadr

namespace kadr::fanuc {

/// Returns the block's word for an axis of the drilling direction, which gives the bottom of the hole; nullptr if there is no such word.
/// `cycle`: the code of the cycle.
///   alarms  not_together: words of both the main and the parallel axis (18.0 does not say), address_twice
Result<const Word*> bottom_word(const BlockContext& m, const CodeRow& cycle);
/// Returns the axis of the bottom word. Without that word, returns the drilling axis of the cycle in force. INFERRED: if no cycle is in
/// force, returns the main axis of the drilling direction, or -1 if the channel lacks this axis.
int drilling_axis(const BlockContext& m, const CodeRow& cycle, const Word* bottom);

}  // namespace kadr::fanuc
