#pragma once
// Wrapped rotary axes (one revolution) and indexers (spec/linuxcnc 10.2).

#include "base/result.h"

namespace kadr {
class BlockContext;
}

namespace kadr::linuxcnc {

/// Checks that an indexer moves only by G0, and alone.
Status indexers_allow(const BlockContext& m);

}  // namespace kadr::linuxcnc
