#pragma once
// BlockStates: what was in force after each of the last blocks. The control reads ahead of the machine, and the display of a motion needs
// the modes of the block that the motion comes from, not the modes of the block being read.
//
// An action's Origin holds the number of its block in the run. A state is
// stored only for a block whose state differs from that of the block before.

#include <cstdint>
#include <deque>
#include <memory>
#include <utility>

#include "control/state/control_state.h"

namespace kadr {

class BlockStates {
 public:
  static constexpr std::size_t most = 4096;  // stored changes of state; they span more motions than all later rooms buffer

  /// Records the state after a block was executed.
  void note(std::uint32_t block, const ControlState& now);
  /// Returns the state after the block; nullptr if the block is too long ago.
  std::shared_ptr<const ControlState> of(std::uint32_t block) const;

 private:
  std::deque<std::pair<std::uint32_t, std::shared_ptr<const ControlState>>> states_;  // {first block with this state; state}
};

}  // namespace kadr
