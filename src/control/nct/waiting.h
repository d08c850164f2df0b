#pragma once
// Waiting codes: the channels of a machine wait for each other at `M501 P12` (spec/nct/14 14.5).

#include <optional>

#include "base/result.h"
#include "control/control.h"

namespace kadr {
class Machinery;
struct Call;
}  // namespace kadr

namespace kadr::nct {

inline constexpr int most_channels = 8;  // 1.2

struct WaitingCodes {
  Control::Waiting mode = Control::Waiting::alarm;
  std::uint32_t known = 0;                  // channels of the machine, bit n: channel n; 0: the set-up does not say
  std::optional<Control::Meeting> meeting;  // waits there
};

/// Channels of the set-up; 0 where it names no other one.
std::uint32_t channels_of(const Setup& setup);

/// CP_NOWT: waiting codes have no effect.
bool waiting_suspended(const Machinery& m);

/// `Mm P…` with m from N2201 to N2202, at most 100 codes: the channel waits for those whose digits stand behind P, in any order.
///   returns  true: it was such a code
///   alarms   own_block; word_missing: no P; channel_list: 0, 9, a channel that the machine has not;
///            channels_wait: this run has no other channels (Control::Waiting::alarm)
///   manual   NCT 14.5
Result<bool> waiting_code(Machinery& m, const Call& call);

}  // namespace kadr::nct
