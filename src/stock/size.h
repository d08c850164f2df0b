#pragma once
// Chooses the cell size of a stock, and estimates the memory that the stock needs.

#include <string>
#include <tl/expected.hpp>

#include "stock/brick/lattice.h"

namespace kadr {

/// Returns the bytes of all bricks if each of them is cut: the most that a stock needs, apart from its sweeps.
double bytes_of_bricks(const Box3& box, double cell);

/// Returns the default cell for a box, a round number in mm: about 400 cells along the longest side and four across the finest tool,
/// but at most 1600 along the longest side, and no finer than `most_bytes` allows.
///   finest  diameter of the finest tool, mm; 0 if unknown
double cell_for(const Box3& box, double most_bytes, double finest = 0);

}  // namespace kadr
