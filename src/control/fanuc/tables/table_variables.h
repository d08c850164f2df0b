#pragma once
// System variables for positions, offsets, work systems and the spindle (spec/nct/23 23.1.5, 23.1.15 to 23.1.22; 25.4, 25.19).

#include "base/vec.h"

namespace kadr {
class BlockContext;
}

namespace kadr::fanuc {

/// Returns the tool length compensation in force on each axis, mm.
Axes length_in_force(const BlockContext& m);

}  // namespace kadr::fanuc
