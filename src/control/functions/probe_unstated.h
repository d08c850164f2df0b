#pragma once
// Decides whether a probe motion has made contact if the set-up does not define which surfaces a probe touches.

#include "control/emitter.h"

namespace kadr {

/// Returns true if the probe motion ended in contact. If the set-up does not define which surfaces a probe touches, the contact is unknown.
/// Then a note is reported, and the program continues as if the probe had made contact at the end of the motion: a person who reads the
/// program would assume this.
inline bool made_contact(Emitter& m, const ProbeAnswer& answer) {
  if (answer.touched || m.probe_stated) return answer.touched;
  m.warn(note(AlarmId::probe_unstated, m.probe_where));
  return true;
}

}  // namespace kadr
