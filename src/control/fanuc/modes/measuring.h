#pragma once
// Probe motions G31 (measuring) and G37 (tool length): how the probe's answer changes positions and tool offsets (spec/nct/21).

#include <cstddef>
#include <cstdint>

#include "action/action.h"
#include "base/result.h"

namespace kadr {
class Emitter;
}

namespace kadr::fanuc {

/// Processes the probe's answer: the next block starts where the motion stopped, and #5061 … have the position at which the probe's signal
/// came (21.1). After G37 the tool offset is corrected (21.3).
///   alarms  probe_window: the signal of G37 came too far from the expected position, or not at all; the offset remains unchanged
///   law     G31 without a signal raises no alarm: the measured position is then the end point
Status accept_answer(Emitter& m, const ProbeAnswer& answer);

}  // namespace kadr::fanuc
