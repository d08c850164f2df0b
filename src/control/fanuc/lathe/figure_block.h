#pragma once
// What a block of the figure of G70 to G73 may contain on a lathe's control (spec/fanuc-t 9.1, 9.11; spec/haas-st 6.2).

#include "base/result.h"
#include "base/span.h"

namespace kadr {
class BlockContext;
}

namespace kadr::fanuc {

/// Which block of the figure is read. A figure of one block is the first and the last at once.
struct FigureBlock {
  bool first = false, last = false;
};

/// Checks the codes and words of the current block, `m.block`, as a block of a figure.
///   where   location of the cycle's block, which the alarms name
///   alarms  figure_first_block: the first block has neither G00 nor G01; figure_unavailable: a statement, or a code other than G00 to G03,
///           G04 and those that have no effect in roughing; figure_corner_last, figure_direct_last: the last block depends on a next one
Status check_figure_block(const BlockContext& m, FigureBlock which, Span where);

}  // namespace kadr::fanuc
