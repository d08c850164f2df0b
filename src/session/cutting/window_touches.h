#pragma once
// Merges the contacts (touches) that the stock of the whole blank and the finer stock of a window have found, so that each contact is
// reported once. It is used by session/cutting/cutting.

#include <vector>

#include "stock/stock.h"

namespace kadr {

bool is_within(const Box3& inner, const Box3& outer);

/// Returns the contacts of both stocks as one list. Inside the window the contacts come from the window's stock, outside from the stock of
/// the whole blank. A contact across a face of the window becomes one contact, with the box around both contacts and the volume from the
/// whole blank. Rings around the axis always come from the whole blank.
///   whole, fine  contacts of the same sweeps, sorted by sweep; at most one per sweep and tool part
///   returns      the merged contacts, sorted in the same order
std::vector<Touch> finer_touches(const Box3& window, const std::vector<Touch>& whole, const std::vector<Touch>& fine);

}  // namespace kadr
