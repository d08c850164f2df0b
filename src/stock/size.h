#pragma once
// How fine a stock is cut, and what it takes.

#include <string>
#include <tl/expected.hpp>

#include "stock/brick/lattice.h"

namespace kadr {

/// Bytes of all bricks, if each is cut: what a stock takes at most, but for the sweeps.
double bytes_of_bricks(const Box3& box, double cell);

/// The cell for a box if none is asked for: some 400 along the longest side, but no more than fits; a round number, mm.
double cell_for(const Box3& box, double most_bytes);

}  // namespace kadr
