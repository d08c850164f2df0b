#pragma once
// An axis that hangs on one of another channel (spec/nct/20 20.2, 20.3): it follows it, or is exchanged with it. The session brings the
// positions of the channels together (session/axis_links).

#include <cstddef>

#include "config/setup.h"

namespace kadr {

struct FarAxis {
  std::size_t axis = 0;               // of this channel
  int other = 0;                      // number of the other one: these run on through the channels
  AxisLink link = AxisLink::follows;  // or exchanged
  double sign = 1;                    // of the motion that it follows with
  friend bool operator==(const FarAxis&, const FarAxis&) = default;
};

}  // namespace kadr
