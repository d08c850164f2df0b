#pragma once

namespace kadr {

/// A change of the override: from `seconds` on, the axes move at `share` of the planned speed; 0 is a feed hold.
struct OverrideChange {
  double seconds = 0, share = 1;
};

}  // namespace kadr
