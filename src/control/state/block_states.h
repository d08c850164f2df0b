#pragma once
// BlockStates: the states after each of the last blocks. The control reads ahead of the machine. The display of a motion therefore needs
// the modes of the block that the motion comes from, not the modes of the block being read.
// An action's Origin holds the number of its block in the run. A state is stored only for a block whose state differs from that of the
// block before.

#include <cstdint>
#include <deque>
#include <memory>
#include <utility>

#include "control/state/control_state.h"

namespace kadr {

class BlockStates {
 public:
  static constexpr std::size_t most = 4096;  // greatest number of stored states; all later rooms of src/ together buffer fewer motions

  /// Records the state after an executed block.
  void note(std::uint32_t block, const ControlState& now);
  /// Returns the state after the block with this number; nullptr if that state is no longer stored.
  std::shared_ptr<const ControlState> of(std::uint32_t block) const;

 private:
  // each stored state with the number of the first block that has this state
  std::deque<std::pair<std::uint32_t, std::shared_ptr<const ControlState>>> states_;
};

}  // namespace kadr
