#pragma once
// Data of a channel that waits for other channels: `M501 P12`. The dialect executes the codes themselves (NCT 14.5).

#include <cstdint>
#include <optional>

#include "action/action.h"

namespace kadr {

/// What a waiting code does.
enum class WaitingMode : std::uint8_t {
  alarm,  // raises the alarm channels_wait, because no other channel can arrive
  meet,   // run() returns Control::State::waiting until release() is called
  pass,   // the waiting code has no effect
};
/// A channel at a waiting code.
struct ChannelMeeting {
  std::uint32_t code = 0;      // number of the waiting code: M…
  std::uint32_t channels = 0;  // channels that must arrive at this code; bit n: channel n
  Origin origin;
};

struct WaitingCodes {
  WaitingMode mode = WaitingMode::alarm;
  std::uint32_t known = 0;                // channels of the machine, bit n: channel n; 0 if the set-up does not list them
  std::optional<ChannelMeeting> meeting;  // where this channel waits
};

}  // namespace kadr
