#pragma once
// LookAhead: accepts Steps with their programmed times and emits them in the same order with the times that the machine needs,
// accelerations included. NCT 6, 7; 4.1.2 for G0.
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
#include "motion/look_ahead/control_speed.h"
#include "motion/look_ahead/speed_plan.h"
#include "motion/time/rapid_time.h"

namespace kadr {

class LookAhead {
 public:
  ///   longer  the time that a motion takes beyond its programmed time, s; negative: it takes less
  using Sink = std::function<void(const Step&, double longer)>;

  /// `rapid`: the axes' rapid rates, mm/min, override included.
  LookAhead(const AxisRoles& roles, const SpeedRules& rules, const Axes& rapid, Sink sink);
  LookAhead(const LookAhead&) = delete;  // the object stores pointers to its own members
  LookAhead& operator=(const LookAhead&) = delete;

  /// Accepts a step (a motion with its time by the TimeEstimate) and emits the steps whose times are final. At most `max_pieces` pieces
  /// are stored: when the storage is full, the older half is planned as if the newest piece ended at rest. That is safe: further pieces
  /// can only raise the speeds in the newer half, and the speeds in the older half are low enough to stop in time. Speed is lost only if
  /// the motions are so short that the machine could not stop within the newer half.
  void consume(const Step& step);

  /// Ends the path at rest and emits all stored steps.
  void finish();

  static constexpr std::size_t max_pieces = 1024;
  static constexpr std::size_t max_actions = 4096;  // most actions stored in total, including actions between motions

 private:
  struct Held {
    KeptStep kept;           // a copy of the step and of the tool position before it, for the later emission
    double longer = 0;       // added time, s
    std::size_t pieces = 0;  // number of path pieces of this motion; 0: its time is known already, or it is the open motion
  };
  /// The last motion at feed. The next motion determines how it ends.
  struct Open {
    Held* held;
    PathShape shape;
    double commanded;       // commanded speed, mm/s
    double enter = 0;       // the highest speed allowed at the motion's start, mm/s
    double slow_until = 0;  // end of the slow zone after an inner corner, mm from the motion's start (nct 6.3.5)
    Axes bend{};            // du/ds at the motion's start (control_speed.h)
    const Motion& motion() const { return std::get<Motion>(held->kept.action.what); }
  };
  /// The last rapid motion, if the next may start before its end.
  struct LastRapid {
    Held* held;
    AxisMask moves;
    double ahead;  // time before its end at which the next rapid motion may start, s
  };

 public:
  /// The state that LookAhead keeps between steps.
  struct Memory {
    std::deque<Held> held;
    std::vector<PathPiece> pieces;
    std::optional<Open> open;             // a copied pointer `held` is invalid; `open_at` replaces it
    std::size_t open_at = 0;              // index of the open motion in Memory::held
    std::optional<LastRapid> last_rapid;  // `last_rapid_at` replaces the pointer in the same manner
    std::size_t last_rapid_at = 0;
    double start_speed = 0;
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
  std::deque<Held> held_;          // in program order; actions after a motion follow that motion
  std::vector<PathPiece> pieces_;  // path pieces of the stored motions, except the open motion
  std::optional<Open> open_;
  std::optional<LastRapid> last_rapid_;
  double start_speed_ = 0;  // speed at the start of the first piece, mm/s
  SpeedPlan plan_;
};

}  // namespace kadr
