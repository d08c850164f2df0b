#pragma once
// How fine a stock is cut, and what it takes.

#include <string>
#include <tl/expected.hpp>

#include "stock/brick/lattice.h"

namespace kadr {

/// Bytes of all bricks, if each is cut: what a stock takes at most, but for the sweeps.
double bytes_of_bricks(const Box3& box, double cell);

/// The cell for a box if none is asked for: some 400 along the longest side, four along the finest tool, but no more than 1600 along
/// the longest side and no more than fits; a round number, mm.
///   finest  diameter of that tool, mm; 0: not known
double cell_for(const Box3& box, double most_bytes, double finest = 0);

}  // namespace kadr
