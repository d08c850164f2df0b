#pragma once
// What was in force when a block had been carried out, for blocks gone by: the machine is behind the control, and whoever looks at a motion
// wants the modes of its block, not those of the one being read.
//
// An action's Origin holds the number of its block in the run; a state is kept only where one differs from that of the block before.

#include <cstdint>
#include <deque>
#include <memory>
#include <utility>

#include "control/state/state.h"

namespace kadr {

class BlockStates {
 public:
  static constexpr std::size_t most = 4096;  // changes of state; of motions, more than all rooms after the control hold back together

  /// A block has been carried out.
  void note(std::uint32_t block, const ControlState& now);
  /// nullptr: it is too long ago.
  std::shared_ptr<const ControlState> of(std::uint32_t block) const;

 private:
  std::deque<std::pair<std::uint32_t, std::shared_ptr<const ControlState>>> states_;  // first block with it
};

}  // namespace kadr
