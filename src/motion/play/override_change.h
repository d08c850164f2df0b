#pragma once

namespace kadr {

/// From a time on the axes go at a share of the planned speed: 0 is a feed hold.
struct OverrideChange {
  double seconds = 0, share = 1;
};

}  // namespace kadr
