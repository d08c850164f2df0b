#pragma once
// A probe motion of which the set-up says nothing.

#include "control/emitter.h"

namespace kadr {

/// Did the motion end in contact? Where the set-up says nothing of probes nobody knows: it is told, and the program goes on as if the
/// probe had touched at the end of the motion, which is what a program that is read at a desk is meant to do.
inline bool made_contact(Emitter& m, const ProbeAnswer& answer) {
  if (answer.touched || m.probe_stated) return answer.touched;
  m.warn(note(AlarmId::probe_unstated, m.probe_where));
  return true;
}

}  // namespace kadr
