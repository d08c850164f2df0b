#pragma once
// Waiting codes: the channels of a machine wait for each other at `M501 P12` (spec/nct/14 14.5).

#include "base/result.h"
#include "control/state/waiting_codes.h"

namespace kadr {
class BlockContext;
struct Call;
struct Setup;
}  // namespace kadr

namespace kadr::nct {

class Nct;

inline constexpr int max_channels = 8;  // greatest number of channels of a machine (NCT 1.2)

/// Returns the channels that the set-up lists, as bits: bit n is channel n; 0 if this is the only channel.
std::uint32_t channels_of(const Setup& setup);

/// Returns true if the signal CP_NOWT is on. While it is on, waiting codes have no effect.
bool waiting_suspended(const Nct& nct);

/// Executes `Mm P…`, where m is from N2201 to N2202 (at most 100 codes). The channel waits for the channels whose numbers are the digits of
/// P, in any order.
///   returns  true if the code was a waiting code
///   alarms   own_block; word_missing: no P; channel_list: 0, 9, a channel that the machine lacks; channels_wait: this run has no other
///            channels (Control::Waiting::alarm)
///   manual   NCT 14.5
Result<bool> waiting_code(BlockContext& m, const Call& call);

}  // namespace kadr::nct
