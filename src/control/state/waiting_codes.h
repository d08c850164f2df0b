#pragma once
// Data of a channel that waits for other channels, at a block such as `M501 P12`. The dialect executes the waiting codes (NCT 14.5).

#include <cstdint>
#include <optional>

#include "action/action.h"

namespace kadr {

/// The effect of a waiting code.
enum class WaitingMode : std::uint8_t {
  alarm,  // a waiting code raises the alarm channels_wait, because no other channel can arrive
  meet,   // the channel waits: run() returns Control::State::waiting until release() is called
  pass,   // the waiting code has no effect
};
/// A waiting code at which a channel waits.
struct ChannelMeeting {
  std::uint32_t code = 0;      // number of the waiting code: M…
  std::uint32_t channels = 0;  // channels that must arrive at this code, as bits: bit n for channel n
  Origin origin;
};

struct WaitingCodes {
  WaitingMode mode = WaitingMode::alarm;
  std::uint32_t known = 0;                // channels of the machine as bits, bit n for channel n; 0 if the set-up lists no channels
  std::optional<ChannelMeeting> meeting;  // the waiting code at which this channel waits; nullopt if the channel does not wait
};

}  // namespace kadr
