#pragma once
// BlockStates: what was in force after each of the last blocks. The machine runs behind the control, and the display of a motion
// needs the modes of its block, not those of the block being read.
//
// An action's Origin holds the number of its block in the run. A state is
// stored only for a block whose state differs from that of the block before.

#include <cstdint>
#include <deque>
#include <memory>
#include <utility>

#include "control/state/state.h"

namespace kadr {

class BlockStates {
 public:
  static constexpr std::size_t most = 4096;  // changes of state; in motions, more than all rooms after the control buffer together

  /// Records the state after a block was executed.
  void note(std::uint32_t block, const ControlState& now);
  /// Returns nullptr if the block is too long ago.
  std::shared_ptr<const ControlState> of(std::uint32_t block) const;

 private:
  std::deque<std::pair<std::uint32_t, std::shared_ptr<const ControlState>>> states_;  // with the first block that it applies to
};

}  // namespace kadr
