#pragma once
// Probe motions G31 and G37: what they measure, and what their answer changes (spec/nct/21).

#include <cstddef>
#include <cstdint>

#include "action/action.h"
#include "base/result.h"

namespace kadr {
class Emitter;
}

namespace kadr::fanuc {

/// The machine's answer: the next block starts where the motion stopped, #5061 … keep the place of the signal (21.1); after G37
/// the offset is corrected (21.3).
///   alarms  probe_window: the signal of G37 came too far off, or not at all; the offset stays
///   law     no signal is no alarm of G31: the place is the end point
Status take_answer(Emitter& m, const ProbeAnswer& answer);

}  // namespace kadr::fanuc
