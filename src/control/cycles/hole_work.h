#pragma once
// What a drilling cycle says of its motions beside where they go: HoleWork of action/action.h.

#include <variant>

#include "action/by_kind.h"
#include "base/result.h"

namespace kadr {

/// Emits into `batch`, and says of the motions among it that a cycle makes them.
template <class Emit>
Status emit_of_cycle(ActionBatch& batch, Emit&& emit) {
  const std::size_t before = batch.size();
  KADR_TRY(emit());
  for (std::size_t i = before; i < batch.size(); ++i)
    if (auto* const motion = motion_of(batch[i])) motion->of_cycle = true;
  return {};
}

/// The same, and what they are for.
template <class Emit>
Status emit_in_hole(ActionBatch& batch, HoleWork work, Emit&& emit) {
  const std::size_t before = batch.size();
  KADR_TRY(emit_of_cycle(batch, emit));
  for (std::size_t i = before; i < batch.size(); ++i)
    if (auto* const motion = motion_of(batch[i])) motion->in_hole = work;
  return {};
}

}  // namespace kadr
