#pragma once
// Handles a probe motion if the set-up does not define probes.

#include "control/emitter.h"

namespace kadr {

/// Returns true if the probe motion ended in contact. If the set-up does not define what a probe touches, this is unknown: a note is
/// given, and the program continues as if the probe had touched at the end of the motion, as someone reading the program at a desk would
/// assume.
inline bool made_contact(Emitter& m, const ProbeAnswer& answer) {
  if (answer.touched || m.probe_stated) return answer.touched;
  m.warn(note(AlarmId::probe_unstated, m.probe_where));
  return true;
}

}  // namespace kadr
