#pragma once

namespace kadr {

/// A change of the override: from the time `seconds` on, the axes move at the planned speed times `share` (0 to 1); 0 is a feed hold.
struct OverrideChange {
  double seconds = 0, share = 1;
};

}  // namespace kadr
