#pragma once
// Marks each motion of a drilling cycle with its purpose in the drilled hole: HoleWork of action/action.h.

#include <variant>

#include "action/by_kind.h"
#include "base/result.h"

namespace kadr {

/// Calls `emit`, which adds motions to `batch`, and marks these motions as those of a canned cycle.
template <class Emit>
Status emit_of_cycle(ActionBatch& batch, Emit&& emit) {
  const std::size_t before = batch.size();
  KADR_TRY(emit());
  for (std::size_t i = before; i < batch.size(); ++i)
    if (auto* const motion = motion_of(batch[i])) motion->of_cycle = true;
  return {};
}

/// Calls emit_of_cycle(), and also marks the motions with `work`, their purpose in the drilled hole.
template <class Emit>
Status emit_in_hole(ActionBatch& batch, HoleWork work, Emit&& emit) {
  const std::size_t before = batch.size();
  KADR_TRY(emit_of_cycle(batch, emit));
  for (std::size_t i = before; i < batch.size(); ++i)
    if (auto* const motion = motion_of(batch[i])) motion->in_hole = work;
  return {};
}

}  // namespace kadr
