#pragma once
// The multiple repetitive cycles G70 to G73 of Fanuc's lathes (spec/fanuc-t 9.1 to 9.6, 9.10).

#include "base/result.h"

namespace kadr {
class Interpreter;
struct Call;
}  // namespace kadr

namespace kadr::functions {

/// Executes a block of G71 or G72 (call.row->arg 710 or 720): a block with P and Q is the cycle; one without P, Q and D sets the depth of a
/// pass and the escape. A block with D, Fanuc's one-block format, is the cycle with this depth.
///   alarms  figure_words, figure_depth, figure_not_monotone, figure_not_monotone_second, figure_first_block, figure_over_start, and those
///           of read_drawing()
Status lathe_rough(Interpreter& m, const Call& call);
/// Executes a block of G73, likewise in two forms. alarms figure_words, pattern_repeats, figure_first_block, those of read_drawing()
Status lathe_pattern(Interpreter& m, const Call& call);
/// Executes the blocks P … Q as G70 does, and returns to the start point. alarms figure_words, figure_block_missing
Status lathe_finish(Interpreter& m, const Call& call);

}  // namespace kadr::functions
