#pragma once
// Merges the touches found by the stock of the whole and by the finer stock of a window, so that each touch comes once. Used by
// session/cutting/cutting.

#include <vector>

#include "stock/stock.h"

namespace kadr {

bool lies_within(const Box3& inner, const Box3& outer);

/// Inside the window the touches of the window count, outside it those of the whole. A touch that crosses a face of the window becomes
/// one: the box around both, with the volume of the whole. Rings surround the axis, so those of the whole count too.
///   whole, fine  of the same sweeps, in their order, one per sweep and tool part
///   returns      in the same order
std::vector<Touch> finer_touches(const Box3& window, const std::vector<Touch>& whole, const std::vector<Touch>& fine);

}  // namespace kadr
