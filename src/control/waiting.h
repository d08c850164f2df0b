#pragma once
// Where a channel waits for others: `M501 P12`. The codes themselves are the dialect's (NCT 14.5).

#include <cstdint>
#include <optional>

#include "control/control.h"

namespace kadr {

struct WaitingCodes {
  Control::Waiting mode = Control::Waiting::alarm;
  std::uint32_t known = 0;                  // channels of the machine, bit n: channel n; 0: the set-up does not say
  std::optional<Control::Meeting> meeting;  // waits there
};

}  // namespace kadr
