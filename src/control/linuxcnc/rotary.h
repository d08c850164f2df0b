#pragma once
// Rotary axes of one turn, and indexers (spec/linuxcnc 10.2).

#include "base/result.h"

namespace kadr {
class BlockContext;
}

namespace kadr::linuxcnc {

/// An indexer goes by G0, and alone.
Status indexers_allow(const BlockContext& m);

}  // namespace kadr::linuxcnc
