#pragma once
// Chooses the edge length of a stock's lattice cells, and estimates the memory that the stock needs.

#include <string>
#include <tl/expected.hpp>

#include "stock/brick/lattice.h"

namespace kadr {

/// Returns the memory of a stock, in bytes, if tools have cut every brick of its lattice: the upper limit, without the stored sweeps.
double bytes_of_bricks(const Box3& box, double cell);

/// Returns the default cell size for a box, rounded to a simple number of mm: about 400 cells along the longest side and four cells
/// across the finest tool, but at most 1600 cells along the longest side, and no finer than `max_bytes` of memory allow.
///   finest  diameter of the finest tool, mm; 0 if unknown
double cell_for(const Box3& box, double max_bytes, double finest = 0);

}  // namespace kadr
