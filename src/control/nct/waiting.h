#pragma once
// Waiting codes: the channels of a machine wait for each other at `M501 P12` (spec/nct/14 14.5).

#include "base/result.h"
#include "control/state/waiting.h"

namespace kadr {
class BlockContext;
struct Call;
struct Setup;
}  // namespace kadr

namespace kadr::nct {

class Nct;

inline constexpr int most_channels = 8;  // 1.2

/// Channels of the set-up; 0 where it names no other one.
std::uint32_t channels_of(const Setup& setup);

/// CP_NOWT: waiting codes have no effect.
bool waiting_suspended(const Nct& nct);

/// `Mm P…` with m from N2201 to N2202, at most 100 codes: the channel waits for those whose digits stand after P, in any order.
///   returns  true: it was such a code
///   alarms   own_block; word_missing: no P; channel_list: 0, 9, a channel that the machine has not;
///            channels_wait: this run has no other channels (Control::Waiting::alarm)
///   manual   NCT 14.5
Result<bool> waiting_code(BlockContext& m, const Call& call);

}  // namespace kadr::nct
