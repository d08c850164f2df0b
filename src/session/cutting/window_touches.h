#pragma once
// What the tool touched, told by the whole and by a window of it that is cut finer: each touch once. For session/cutting/cutting.

#include <vector>

#include "stock/stock.h"

namespace kadr {

bool lies_within(const Box3& inner, const Box3& outer);

/// Within the window its own touches count, beyond it those of the whole. A touch that goes through a face of the window is one: the boxes
/// of both together, with the volume of the whole. Rings lie all around: those of the whole count, too.
///   whole, fine  of the same sweeps, in their order, one a sweep and part
///   returns      in the same order
std::vector<Touch> finer_touches(const Box3& window, const std::vector<Touch>& whole, const std::vector<Touch>& fine);

}  // namespace kadr
