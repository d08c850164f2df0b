#pragma once
// PanelBlocks is the queue of the motions that the control has executed and the machine has not executed yet. It finds the block to which
// an instant of the servo clock belongs, and the modes, the tool and the spindle that are in force in this block.

#include <deque>
#include <memory>
#include <vector>

#include "action/in_force.h"
#include "action/step.h"
#include "control/lathe_modes.h"

namespace kadr {

/// The modes, the tool and the spindle that are in force after a block.
struct PanelModes {
  std::vector<InForce> in_force;
  std::vector<AlarmReport::Call> calls;
  LatheModes lathe;
};

/// A motion that the machine executes.
struct PanelBlock {
  Origin origin;
  std::uint64_t motion = 0;  // Number of the motion. AxisMotion counts from 1 at each start of motion; 0 means no motion.
  Axes work{}, machine{};    // work and machine coordinates at the end of the motion, mm or degrees
  Placement placement;       // position of the work coordinate system in machine coordinates during the motion
  double feed = 0;           // programmed feed, mm/min; 0 in a rapid motion
  double factor = 1;         // feed override above 1 with which the motion is planned, as a factor of the programmed feed
  bool by_turn = false;      // true if the feed of the motion was programmed per revolution of the spindle
  std::uint32_t number = 0;  // Number of the block in the run, without the operator's lines; 0: the block is not part of the program.
  bool entered = false;      // True if the motion comes from a line that the operator entered. Such a line is in no file.
  std::shared_ptr<const PanelModes> modes;

  /// Returns the work coordinates at the machine position `at`, which the axes reach during this motion.
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
  /// Returns the block of the motion with this number and removes the blocks before it. Returns nullptr if no block has this number.
  const PanelBlock* at(std::uint64_t motion) {
    while (blocks_.size() > 1 && blocks_[1].motion <= motion) blocks_.pop_front();
    return blocks_.empty() || motion == 0 ? nullptr : &blocks_.front();
  }

 private:
  std::deque<PanelBlock> blocks_;
};

}  // namespace kadr
