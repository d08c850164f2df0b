#pragma once
// LookAhead: Steps with their programmed times in, the same in order with the times that the machine takes. NCT 6, 7; 4.1.2 for G0.
//
//   motions at feed ──▶ a path of pieces, as long as nothing makes the axes stand ──▶ SpeedPlan ──▶ each motion's time
//   rapid: each from rest to rest, or overlapping the next (N0421 ROL)
//
// Threads and polar interpolation keep their programmed time: the spindle leads there, here the rotary axis (6.2, 4.5). They begin and
// end at rest, as does a probe's motion.

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
  ///   longer  than its programmed time a motion takes, s; negative: shorter
  using Sink = std::function<void(const Step&, double longer)>;

  /// `rapid`: the axes' rapid rates, mm/min, override included.
  LookAhead(const AxisRoles& roles, const SpeedRules& rules, const Axes& rapid, Sink sink);
  LookAhead(const LookAhead&) = delete;  // it points into what it holds
  LookAhead& operator=(const LookAhead&) = delete;

  /// Takes a step, a motion with its time by the TimeEstimate; emits what is decided by now. Holds at most `most_pieces` motions: when
  /// full, the older half is decided as if the newest ended at rest. That is safe: with more to come the speeds at the end can only rise,
  /// and those of the older half are low enough to stop; what is lost is speed in runs of motions so short that the machine could not stop
  /// within the newer half.
  void consume(const Step& step);

  /// Nothing follows: what is held ends at rest.
  void finish();

  static constexpr std::size_t most_pieces = 1024;
  static constexpr std::size_t most_actions = 4096;  // held in all, with what stands between the motions

 private:
  struct Held {
    KeptStep kept;           // it is emitted later: with where the tool stood then
    double longer = 0;       // s
    std::size_t pieces = 0;  // of the path; 0: its time is known, or it is the open one
  };
  /// The last motion at feed: what comes next says how it ends.
  struct Open {
    Held* held;
    PathShape shape;
    double commanded;       // mm/s
    double enter = 0;       // the highest speed at its start, mm/s
    double slow_until = 0;  // mm from its start, after an inner corner (nct 6.3.5)
    Axes bend{};            // where it begins
    const Motion& motion() const { return std::get<Motion>(held->kept.action.what); }
  };
  /// The last rapid motion, where the next may begin before it ends.
  struct LastRapid {
    Held* held;
    AxisMask moves;
    double ahead;  // s before its end
  };

 public:
  /// What it remembers from step to step.
  struct Memory {
    std::deque<Held> held;
    std::vector<PathPiece> pieces;
    std::optional<Open> open;             // points to …
    std::size_t open_at = 0;              // … the held one there
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
  Axes rapid_rates_{};  // per s
  Sink sink_;
  std::deque<Held> held_;          // in order; what stands after the last motion follows it
  std::vector<PathPiece> pieces_;  // of the held motions, the open one excepted
  std::optional<Open> open_;
  std::optional<LastRapid> last_rapid_;
  double start_speed_ = 0;  // mm/s, at the first piece
  SpeedPlan plan_;
};

}  // namespace kadr
