#pragma once
// System variables that show positions, offsets, work systems, the spindle (spec/nct/23 23.1.5, 23.1.15 to 23.1.22; 25.4, 25.19).

#include "base/vec.h"

namespace kadr {
class BlockContext;
}

namespace kadr::fanuc {

/// Of the tool as it is taken into account now, on each axis, mm.
Axes length_in_force(const BlockContext& m);

}  // namespace kadr::fanuc
