#pragma once
// Lines between G10 L52, L75, L76, L77 and G11: data, no blocks (spec/nct/24 24.1, 12 12.4); exclusive M codes (13.1, 11.2).

#include "base/result.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::fanuc {

/// One data line.
///   alarms  value_out_of_range (2002), word_missing (2004), parameter_not_writable (2193), data_block
Status data_line(Emitter& m);
/// Two M codes of one exclusive group, or two spindle codes. alarms m_codes_contradict
Status check_m_codes(const BlockContext& m);

}  // namespace kadr::fanuc
