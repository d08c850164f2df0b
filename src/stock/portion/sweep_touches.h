#pragma once
// Joins the touches of bricks: one touch for each sweep and tool part. Used by stock/stock.

#include <vector>

#include "stock/stock.h"

namespace kadr {

/// Returns one touch for each sweep and tool part, in the order of the sweeps, from touches of single bricks in any order. Volumes are
/// added in an order that depends on the touches alone, so the bits of the sums do too.
std::vector<Touch> one_for_each_sweep(std::vector<Touch> touches);

}  // namespace kadr
