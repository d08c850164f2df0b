#pragma once
// Shortens repetitions after a fault, so that a check does not wait for them.

#include <algorithm>

#include "control/flow/flow.h"

namespace kadr {

/// Called at the end of a call or repetition with very many passes, after a fault that `kadr check` has reported. One pass shows the
/// faults of the body; the other passes would take minutes and end with a false endless_program. INFERRED: up to 1000 passes are still
/// executed, so that increments add up.
inline void shorten_after_fault(const AlarmReport& last, Flow& flow) {
  constexpr std::uint32_t max_passes = 1000;
  if (last.alarm.id == no_alarm || flow.depth() == 0) return;
  std::uint32_t& left = flow.frames().back().left;
  if (left > max_passes) left = 1;
}

}  // namespace kadr
