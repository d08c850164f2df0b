#pragma once
// LookAhead accepts Steps with their programmed times. It emits the same Steps in the same order with the times that the machine needs,
// including acceleration: NCT 6 and 7, and 4.1.2 for G0.
//
//   motions at feed ──▶ a path of pieces, until the axes must stop ──▶ SpeedPlan ──▶ time of each motion
//   rapid motions: each from rest to rest, or overlapping the next (N0421 ROL)
//
// Threads and polar interpolation keep their programmed time, because the spindle or the rotary axis determines it (NCT 6.2, 4.5). Threads,
// polar interpolation and probe motions start and end at rest.

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "action/step.h"
#include "motion/look_ahead/block_window.h"
#include "motion/look_ahead/control_speed.h"
#include "motion/look_ahead/speed_plan.h"
#include "motion/time/rapid_time.h"

namespace kadr {

class LookAhead {
 public:
  ///   longer  the actual time of a motion minus its programmed time, s; negative if the motion takes less time than programmed
  using Sink = std::function<void(const Step&, double longer)>;

  /// `rapid`: the rapid rates of the axes, mm/min or degrees/min; the rapid override is included.
  LookAhead(const AxisRoles& roles, const SpeedRules& rules, const Axes& rapid, Sink sink);
  LookAhead(const LookAhead&) = delete;  // Copying is disabled because the object stores pointers to its own members.
  LookAhead& operator=(const LookAhead&) = delete;

  /// Accepts a step and emits the steps whose times are final. A motion must have the time that TimeEstimate computes. At most `max_pieces`
  /// path pieces are stored. When the storage is full, the older half is planned as if the newest piece ended at rest. This is safe,
  /// because further pieces can only raise the speeds in the newer half, and the speeds in the older half are low enough that the axes can
  /// stop in time. Speed is lost only if the motions are so short that the machine could not stop within the newer half.
  void consume(const Step& step);

  /// Ends the path at rest and emits all stored steps.
  void finish();

  static constexpr std::size_t max_pieces = 1024;
  static constexpr std::size_t max_actions = 4096;  // the greatest number of stored actions, including the actions between motions

 private:
  struct Held {
    KeptStep kept;      // a copy of the step and of the tool position before the step; the step is emitted later
    double longer = 0;  // time, s, by which the planned motion takes longer than its programmed time
    // Number of path pieces of this motion. 0: the time of the motion is already known, or the motion is the open motion.
    std::size_t pieces = 0;
  };
  /// The last motion at feed. Its end speed is not known until the next motion arrives.
  struct Open {
    Held* held;
    PathShape shape;
    double commanded;       // commanded speed, mm/s
    double enter = 0;       // the highest allowed speed at the start of the motion, mm/s
    double slow_until = 0;  // length of the slow zone after an inner corner, measured from the start of the motion, mm (nct 6.3.5)
    Axes bend{};  // curvature vector du/ds at the start of the motion, 1/mm, where u is the direction of the path (control_speed.h)
    const Motion& motion() const { return std::get<Motion>(held->kept.action.what); }
  };
  /// The last rapid motion, if the next rapid motion may start before the end of this motion.
  struct LastRapid {
    Held* held;
    AxisMask moves;
    double ahead;  // time before the end of this motion at which the next rapid motion may start, s
  };

 public:
  /// The state that LookAhead keeps between steps.
  struct Memory {
    std::deque<Held> held;
    std::vector<PathPiece> pieces;
    std::optional<Open> open;             // The pointer `held` is invalid in a copy, so resume_from() sets it again from `open_at`.
    std::size_t open_at = 0;              // index of the open motion, whose end speed is not known yet, in Memory::held
    std::optional<LastRapid> last_rapid;  // The pointer `held` is invalid in a copy, so resume_from() sets it again from `last_rapid_at`.
    std::size_t last_rapid_at = 0;
    double start_speed = 0;
    std::optional<BlockWindow::Memory> window;
  };
  Memory memory() const;
  void resume_from(const Memory& memory);

 private:
  void motion(const Step& step, const Motion& motion);
  void rapid(const Step& step, const Motion& motion, const PathShape& shape, bool exact);
  void cut(const Step& step, const PathShape& shape, bool exact);
  void join(Open& next);
  void limit_step(Open* next, const Axes& bend);
  void close(double slow_from);
  void rest();
  void plan_older();
  std::size_t place_to_part() const;
  void release(std::size_t pieces);
  void hold(const Step& step);

  AxisRoles roles_;
  SpeedRules rules_;
  Axes rapid_rates_{};  // rapid rates of the axes, mm/s or degrees/s
  Sink sink_;
  std::deque<Held> held_;          // stored steps in program order; an action that follows a motion in the program also follows it here
  std::vector<PathPiece> pieces_;  // path pieces of the stored motions, except the open motion, whose end speed is not known yet
  std::optional<Open> open_;
  std::optional<LastRapid> last_rapid_;
  double start_speed_ = 0;  // speed at the start of the first piece, mm/s
  SpeedPlan plan_;
  std::optional<BlockWindow> window_;  // used instead of all of this, if the rules have a planner of a few blocks
};

}  // namespace kadr
