#pragma once
// Chooses the edge length of a stock's lattice cells, and estimates the memory that the stock needs.

#include <string>
#include <tl/expected.hpp>

#include "stock/brick/lattice.h"

namespace kadr {

/// Returns an upper limit, in bytes, of the memory of a stock for the case that tools have cut every brick of the lattice. The limit does
/// not include the stored sweeps.
double bytes_of_bricks(const Box3& box, double cell);
/// The same for the bricks that a lattice holds.
double bytes_of_bricks(const Lattice& lattice);

/// Returns the default edge length of a lattice cell for a box, rounded to a simple number of mm. The default is about 400 cells along the
/// longest side and four cells across the finest tool, but at most 1600 cells along the longest side, and no more cells than `max_bytes` of
/// memory allow.
///   finest  diameter of the finest tool, mm; 0 if unknown
double cell_for(const Box3& box, double max_bytes, double finest = 0);

}  // namespace kadr
