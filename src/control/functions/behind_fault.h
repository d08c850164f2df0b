#pragma once
// What a check does not wait for after a fault.

#include <algorithm>

#include "control/flow/flow.h"

namespace kadr {

/// The end of a call or repetition that is to be made very often, after a fault that `kadr check` has told: one pass shows the faults in
/// it, the others cost minutes and end with a false endless_program. INFERRED: 1000 passes are still made, so that increments add up.
inline void shorten_behind_fault(const AlarmReport& last, Flow& flow) {
  constexpr std::uint32_t most_passes = 1000;
  if (last.alarm.id == no_alarm || flow.depth() == 0) return;
  std::uint32_t& left = flow.frames().back().left;
  if (left > most_passes) left = 1;
}

}  // namespace kadr
