#pragma once
// Interrupt macro: M96, M97, the signal CP_MINT (spec/nct/23 23.4).

#include "base/result.h"

namespace kadr {
class Machinery;
}

namespace kadr::nct {

enum class BlockMoment : std::uint8_t { start, end };

/// Calls the interrupt macro if it is enabled and the signal asks for it. INFERRED: with TPI=0 before the block that would begin,
/// with TPI=1 behind the block.
///   returns  true: it was called; at the start of a block: instead of the block, which follows the macro
Result<bool> call_interrupt(Machinery& m, BlockMoment moment);

}  // namespace kadr::nct
