#pragma once
// Data lines between G10 L52, L75, L76, L77 and G11, which are not executed as blocks (spec/nct/24 24.1, 12 12.4), and the check of
// exclusive M codes (13.1, 11.2).

#include "base/result.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::fanuc {

/// Executes one data line: the line writes a parameter (after G10 L52) or tool data (after G10 L75, L76, L77).
///   alarms  value_out_of_range (2002), word_missing (2004), parameter_not_writable (2193), data_block
Status data_line(Emitter& m);
/// Checks that no two M codes of the block belong to one exclusive group, and that at most one is a spindle code. alarms m_codes_contradict
Status check_m_codes(const BlockContext& m);

}  // namespace kadr::fanuc
