#pragma once
// BlockWindow plans as a controller whose planner holds a few straight blocks: Grbl (planner.c, motion_control.c of 1.1h; spec/grbl 2, 10).
//
//   motions, rapids too ──arcs as chords──▶ a window of 15 blocks ──▶ speed at each junction ──▶ time of the oldest block
//
// The oldest block is executed while the others are planned as if the newest one ended at rest. So short blocks are slow: the speed is
// never higher than what the axes can stop from within the window.

#include <deque>
#include <functional>

#include "action/step.h"
#include "motion/look_ahead/speed_rules.h"

namespace kadr {

class BlockWindow {
 public:
  using Sink = std::function<void(const Step&, double longer)>;  // as LookAhead::Sink

  /// `rates`: the greatest speed of each axis, mm/s
  BlockWindow(const AxisRoles& roles, const SpeedRules& rules, const Axes& rates, Sink sink);

  /// Accepts a step and emits the steps whose times are final.
  void consume(const Step& step);
  /// Ends the path at rest and emits all stored steps.
  void finish() { rest(); }

  struct Held {
    KeptStep kept;
    double longer = 0;       // planned minus programmed time, s
    std::size_t blocks = 0;  // blocks of this motion that are not planned yet
  };
  /// A straight block of the planner.
  struct Block {
    double length = 0;        // mm
    double nominal = 0;       // commanded speed within the limits of the axes, mm/s
    double acceleration = 0;  // mm/s²
    double max_entry_sq = 0;  // greatest squared speed at its start, mm²/s²
    Axes direction{};         // unit vector
  };
  /// The state between steps.
  struct Memory {
    std::deque<Held> held;
    std::deque<Block> blocks;
    double entry = 0;
  };
  Memory memory() const { return {held_, blocks_, entry_}; }
  void resume_from(const Memory& memory);

 private:
  void motion(const Step& step, const Motion& motion);
  void add(const Axes& travel, double speed, bool rapid);
  double junction_sq(const Block& before, const Block& after) const;
  void plan_oldest();
  void note(const Block& block, double exit, double seconds);
  void rest();
  void release();
  double axis_limit(const Axes& most, const Axes& direction) const;

  AxisRoles roles_;
  SpeedRules rules_;
  Axes rates_;
  Sink sink_;
  std::deque<Held> held_;
  std::deque<Block> blocks_;
  double entry_ = 0;  // speed at the start of the oldest block, mm/s
};

}  // namespace kadr
