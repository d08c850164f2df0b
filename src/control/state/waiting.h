#pragma once
// Where a channel waits for others: `M501 P12`. The codes themselves are the dialect's (NCT 14.5).

#include <cstdint>
#include <optional>

#include "action/action.h"

namespace kadr {

/// What a waiting code does.
enum class WaitingMode : std::uint8_t {
  alarm,  // nobody can come: alarm channels_wait
  meet,   // Control::State::waiting until release()
  pass,   // nothing
};
/// A channel at a waiting code.
struct ChannelMeeting {
  std::uint32_t code = 0;      // M…
  std::uint32_t channels = 0;  // to be synchronised; bit n: channel n
  Origin origin;
};

struct WaitingCodes {
  WaitingMode mode = WaitingMode::alarm;
  std::uint32_t known = 0;                // channels of the machine, bit n: channel n; 0: the set-up does not say
  std::optional<ChannelMeeting> meeting;  // waits there
};

}  // namespace kadr
