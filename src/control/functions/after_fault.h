#pragma once
// Shortens repetitions after a fault, so that `kadr check` does not execute all of them.

#include <algorithm>

#include "control/flow/flow.h"

namespace kadr {

/// Ends a repetition that has more than 1000 remaining passes, after a fault that `kadr check` has reported. The end of each pass of a call
/// or repetition calls this function. One pass shows the faults of the repeated blocks; the other passes would take minutes and end with a
/// false alarm endless_program. INFERRED: if at most 1000 passes remain, all of them are executed, so that increments add up.
inline void shorten_after_fault(const AlarmReport& last, Flow& flow) {
  constexpr std::uint32_t max_passes = 1000;
  if (last.alarm.id == no_alarm || flow.depth() == 0) return;
  std::uint32_t& left = flow.frames().back().left;
  if (left > max_passes) left = 1;
}

}  // namespace kadr
