// Stores the states after past blocks. Used by Control::state_of(); tested by tests/control/block_states_test.cpp.

#include "control/state/block_states.h"

#include <algorithm>

namespace kadr {
namespace {

/// Returns true if block number `a` is after `b`. Block numbers wrap around after 2^32 blocks, so the sign of their difference gives their
/// order.
bool is_after(std::uint32_t a, std::uint32_t b) { return static_cast<std::int32_t>(a - b) > 0; }

// number of blocks after which an unchanged state is stored again, so that is_after() stays correct
constexpr std::uint32_t renewed = 1u << 30;

/// Returns true if the states are equal apart from the tool position, which is in the motions themselves.
bool same_modes(const ControlState& a, const ControlState& b) {
  return a.modal == b.modal && a.transform == b.transform && a.frames == b.frames && a.set_position == b.set_position &&
         a.set_position_by_g52 == b.set_position_by_g52 && a.zero_shift == b.zero_shift;
}

}  // namespace

void BlockStates::note(std::uint32_t block, const ControlState& now) {
  if (!states_.empty()) {
    auto& [first, last] = states_.back();
    if (same_modes(*last, now) && block - first < renewed) return;
    if (first == block) {
      last = std::make_shared<const ControlState>(now);
      return;
    }
  }
  states_.emplace_back(block, std::make_shared<const ControlState>(now));
  if (states_.size() > most) states_.pop_front();
}

std::shared_ptr<const ControlState> BlockStates::of(std::uint32_t block) const {
  const auto after = std::partition_point(states_.begin(), states_.end(), [&](const auto& state) { return !is_after(state.first, block); });
  return after == states_.begin() ? nullptr : std::prev(after)->second;
}

}  // namespace kadr
