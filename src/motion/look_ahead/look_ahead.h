#pragma once
// LookAhead: takes Steps with their programmed times and emits them in order with the times that the machine needs. NCT 6, 7; 4.1.2 for
// G0.
//
//   motions at feed ──▶ a path of pieces, as long as nothing makes the axes stop ──▶ SpeedPlan ──▶ time of each motion
//   rapid motions: each from rest to rest, or overlapping the next (N0421 ROL)
//
// Threads and polar interpolation keep their programmed time, because the spindle or the rotary axis determines it (6.2, 4.5). They start
// and end at rest, as does a probe motion.

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
  LookAhead(const LookAhead&) = delete;  // holds pointers into its own members
  LookAhead& operator=(const LookAhead&) = delete;

  /// Takes a step (a motion with its time by the TimeEstimate) and emits the steps whose times are final. Holds at most `most_pieces`
  /// pieces: when it is full, the older half is planned as if the newest piece ended at rest. That is safe: further pieces can only raise
  /// the speeds at the end, and those of the older half are low enough to stop. It loses speed only in runs of motions so short that the
  /// machine could not stop within the newer half.
  void consume(const Step& step);

  /// Ends the path: what is held ends at rest.
  void finish();

  static constexpr std::size_t most_pieces = 1024;
  static constexpr std::size_t most_actions = 4096;  // held in total, including the actions between motions

 private:
  struct Held {
    KeptStep kept;           // a copy, with the tool position of its time, as it is emitted later
    double longer = 0;       // s
    std::size_t pieces = 0;  // pieces of the path; 0: its time is known, or it is the open motion
  };
  /// The last motion at feed. The next motion determines how it ends.
  struct Open {
    Held* held;
    PathShape shape;
    double commanded;       // mm/s
    double enter = 0;       // the highest speed at its start, mm/s
    double slow_until = 0;  // mm from its start: the slow zone after an inner corner (nct 6.3.5)
    Axes bend{};            // at its start
    const Motion& motion() const { return std::get<Motion>(held->kept.action.what); }
  };
  /// The last rapid motion, if the next may start before its end.
  struct LastRapid {
    Held* held;
    AxisMask moves;
    double ahead;  // s before its end
  };

 public:
  /// The state that it keeps from step to step.
  struct Memory {
    std::deque<Held> held;
    std::vector<PathPiece> pieces;
    std::optional<Open> open;             // its pointer is replaced by …
    std::size_t open_at = 0;              // … this index into `held`
    std::optional<LastRapid> last_rapid;  // likewise
    std::size_t last_rapid_at = 0;
    double start_speed = 0;
  };
  Memory memory() const;
  void remember(const Memory& memory);

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
  Axes rapid_rates_{};  // mm or degrees per s
  Sink sink_;
  std::deque<Held> held_;          // in order; actions after the last motion follow it
  std::vector<PathPiece> pieces_;  // of the held motions, except the open one
  std::optional<Open> open_;
  std::optional<LastRapid> last_rapid_;
  double start_speed_ = 0;  // mm/s, at the first piece
  SpeedPlan plan_;
};

}  // namespace kadr
