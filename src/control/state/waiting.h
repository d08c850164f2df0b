#pragma once
// Data of a channel that waits for other channels: `M501 P12`. The dialect executes the codes themselves (NCT 14.5).

#include <cstdint>
#include <optional>

#include "action/action.h"

namespace kadr {

/// What a waiting code does.
enum class WaitingMode : std::uint8_t {
  alarm,  // alarm channels_wait, because no other channel can come
  meet,   // run() returns Control::State::waiting until release()
  pass,   // it has no effect
};
/// A channel at a waiting code.
struct ChannelMeeting {
  std::uint32_t code = 0;      // M…
  std::uint32_t channels = 0;  // channels to be synchronised; bit n: channel n
  Origin origin;
};

struct WaitingCodes {
  WaitingMode mode = WaitingMode::alarm;
  std::uint32_t known = 0;                // channels of the machine, bit n: channel n; 0 if the set-up does not list them
  std::optional<ChannelMeeting> meeting;  // where this channel waits
};

}  // namespace kadr
