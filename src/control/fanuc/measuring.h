#pragma once
// Probe motions G31 and G37: what they measure, and what their answer changes (spec/nct/21).

#include <cstddef>
#include <cstdint>

#include "action/action.h"
#include "base/result.h"

namespace kadr {
class Interpreter;
}

namespace kadr::nct {

/// What the probe motion under way is for; its answer finishes it.
struct Measurement {
  bool length = false;       // G37: an offset is corrected
  std::size_t axis = 0;      // along which
  double expected = 0;       // mm, work coordinate of the signal
  double window = 0;         // mm, N3005: how far from it the signal may come
  std::uint32_t offset = 0;  // number of the register
};

/// The machine's answer: the next block starts where the motion stopped, #5061 … keep the place of the signal (21.1); after G37
/// the offset is corrected (21.3).
///   alarms  probe_window: the signal of G37 came too far off, or not at all; the offset stays
///   law     no signal is no alarm of G31: the place is the end point
Status take_answer(Interpreter& m, const ProbeAnswer& answer);

}  // namespace kadr::nct
