#pragma once
// PanelBlocks: the motions that the control has executed and the machine has not yet. Finds the block that an instant of the servo clock
// belongs to, and what is in force then.

#include <deque>
#include <memory>
#include <vector>

#include "action/in_force.h"
#include "action/step.h"

namespace kadr {

/// What is in force after a block.
struct PanelModes {
  std::vector<InForce> in_force;
  std::vector<AlarmReport::Call> calls;
};

/// A motion that the machine executes.
struct PanelBlock {
  Origin origin;
  std::uint64_t motion = 0;  // numbered by AxisMotion from 1 in each stretch; 0: none
  Axes work{}, machine{};    // coordinates at its end
  Placement placement;       // of the work coordinate system
  double feed = 0;           // as programmed, mm/min; 0 at rapid
  bool by_turn = false;      // the feed is per revolution of the spindle
  std::uint32_t number = 0;  // of the block in the run, not counting lines of the operator; 0: not of the program
  bool entered = false;      // from a line of the operator, which is in no file
  std::shared_ptr<const PanelModes> modes;

  /// Work coordinates during the motion, at machine position `at`.
  Axes work_of(const Axes& at) const {
    if (!placement.is_plain()) return placement.work_of(at);
    Axes now = work;
    for (std::size_t a = 0; a < max_axes; ++a) now[a] -= machine[a] - at[a];
    return now;
  }
};

class PanelBlocks {
 public:
  void clear() { blocks_.clear(); }
  void add(PanelBlock block) { blocks_.push_back(std::move(block)); }
  /// The block of the motion; earlier blocks are forgotten. Returns nullptr if it is not known.
  const PanelBlock* at(std::uint64_t motion) {
    while (blocks_.size() > 1 && blocks_[1].motion <= motion) blocks_.pop_front();
    return blocks_.empty() || motion == 0 ? nullptr : &blocks_.front();
  }

 private:
  std::deque<PanelBlock> blocks_;
};

}  // namespace kadr
