#pragma once
// Wrapped rotary axes, which count one revolution only, and indexers, which move only by G0 (spec/linuxcnc 10.2).

#include "base/result.h"

namespace kadr {
class BlockContext;
}

namespace kadr::linuxcnc {

/// Checks that each indexer that the block moves is moved by G0, and that no other axis moves in the block.
Status indexers_allow(const BlockContext& m);

}  // namespace kadr::linuxcnc
