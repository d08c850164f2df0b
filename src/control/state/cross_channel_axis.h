#pragma once
// CrossChannelAxis: an axis that is coupled to, or exchanged with, an axis of another channel (spec/nct/20 20.2, 20.3). The session
// exchanges the positions between the channels (session/axis_links).

#include <cstddef>

#include "config/setup/setup.h"

namespace kadr {

struct CrossChannelAxis {
  std::size_t axis = 0;               // index in this channel of the axis that is coupled or exchanged
  int other = 0;                      // number of the axis in the other channel; axis numbers are unique across the channels
  AxisLink link = AxisLink::follows;  // whether the axis follows the other axis, or the two axes are exchanged
  double sign = 1;                    // direction of a following axis: +1 that of the other axis, -1 the opposite direction
  friend bool operator==(const CrossChannelAxis&, const CrossChannelAxis&) = default;
};

}  // namespace kadr
