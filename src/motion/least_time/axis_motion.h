#pragma once
// AxisMotion: Steps → the axes' motion in time, by the Planner: what a motion's curve is in machine coordinates, where the axes
// stand still, what a pause lasts. Threads and rigid tapping go in step with the spindle, of which the angle comes along.

#include <deque>
#include <functional>

#include "config/machine_profile.h"
#include "config/setup.h"
#include "motion/least_time/led_corner.h"
#include "motion/least_time/planner.h"
#include "motion/least_time/smoothing.h"
#include "motion/least_time/thread_chain.h"
#include "motion/time/estimate.h"
#include "motion/time/pace.h"
#include "motion/time/spindle_clock.h"
#include "path/curve/machine_path.h"

namespace kadr {

/// What the profile and the setup say; the setup goes before.
MotionLimits motion_limits(const MachineProfile& profile, const Setup& setup, const std::vector<std::string>& axes);

/// What a stretch of time is spent on, and for which line: the tag of a cell.
struct Spent {
  enum class On : std::uint8_t { cutting, rapid, dwell, tool_change };
  On on = On::cutting;
  std::uint32_t line = 0;
  std::uint16_t file = 0;  // Origin::file
  std::uint64_t tag() const { return std::uint64_t{line} << 32 | std::uint64_t{file} << 16 | static_cast<std::uint64_t>(on); }
  static Spent of(std::uint64_t tag) {
    return {static_cast<On>(tag & 0xFF), static_cast<std::uint32_t>(tag >> 32), static_cast<std::uint16_t>(tag >> 16 & 0xFFFF)};
  }
};

/// How far what was planned is not what it should be.
struct PlanFaults {
  std::size_t unsolved = 0;  // stretches for which no speed was found (TimedCells::unsolved);
  double unsolved_way = 0;   // mm, of them all
  Spent unsolved_at;         // the first
  double beyond = 0;         // of its tolerance: how far the path is beyond it at most;
  Spent beyond_at;           // the first such place
};

/// mm/s: the feed of a motion whose programmed time is unknown (override 0, the spindle stands).
inline constexpr double unlimited_feed = 1e6;

class AxisMotion {
 public:
  /// `tolerance`: mm, of corners for which the program states none.
  AxisMotion(const AxisRoles& roles, const MotionLimits& limits, double tolerance, const ToolPosition& start, Planner::Sink sink);
  AxisMotion(const AxisMotion&) = delete;  // the planner points back to it
  AxisMotion& operator=(const AxisMotion&) = delete;

  /// How the main spindle turns at the start, and the parameters of smoothing.
  void start(const Setup& setup, const std::vector<std::string>& axes);

  /// Called for each motion before it is planned: its number, CellSource::motion of its cells, and mm of what their lengths about add up
  /// to.
  std::function<void(std::uint64_t number, double way)> on_motion;

  /// Called for each motion before it is planned: its number and from where it goes, in which frame.
  std::function<void(std::uint64_t number, const ToolPosition& from)> on_place;

  /// A step with its time by programmed feed.
  void consume(const Step& step);
  /// The axes come to rest.
  void finish() { rest(); }

  /// Planner::plan_each().
  void plan_each(double seconds) { planner_.plan_each(seconds); }
  /// Planner::work_side_by_side(), Planner::settle().
  void work_side_by_side() { planner_.work_side_by_side(); }
  void settle() { planner_.settle(); }
  /// All feeds but those of threads are this one, mm/min; 0: as programmed.
  void run_dry(double feed) { dry_feed_ = feed; }

  /// Asked by all that may take long.
  void stop_by(StopToken stop);
  /// Why nothing more is handed out; from then on actions are passed over.
  PlanEnd ended() const { return planner_.ended(); }
  /// Planner::end_here().
  void end_here() { planner_.end_here(); }
  const PlanFaults& faults() const { return now_.faults; }
  /// What the planner would not hand out, by an error of its own.
  struct Refused {
    double way = 0;  // mm
    Spent at;
  };
  Refused refused() const;

 private:
  /// A motion of which cells are still to come.
  struct Record {
    std::uint64_t motion, spent;
    Switches switches;
    SpindleTurning spindle;
    double spindle_part;  // override / 100
    double shift;         // work coordinate less machine coordinate, of the axis that tells the surface speed, mm
  };

 public:
  /// What it remembers from step to step; it is settled.
  struct Memory {
    explicit Memory(const MotionLimits& limits) : threads(limits) {}
    std::deque<Record> records;
    std::uint64_t motions = 0;
    bool exact = true;  // the last motion ended exactly: no rounding after it
    LedPiece led;       // the piece planned last, where it led the tip
    SpindleClock spindle;
    Smoothing smoothing;
    ThreadChain threads;  // not yet cut
    Spent thread_spent;   // of the first of them
    PlanFaults faults;
    double thread_angle = 0;  // of the spindle where the next thread begins, degrees since a zero pulse
  };
  struct Snapshot {
    Memory own;
    Planner::Memory planner;
  };
  Snapshot snapshot() const { return {now_, planner_.memory()}; }
  void restore(const Snapshot& from) { now_ = from.own, planner_.remember(from.planner); }

 private:
  /// The way of a motion, mm, and the speed of each of its pieces, mm/s between its ends; the last one counts for all that follow.
  struct Feeds {
    double length;
    std::vector<double> speeds;
  };
  std::uint64_t record(Spent spent, Switches switches, const Motion& motion);
  static double spindle_rate(const Record& record, const TimedCells& cells, std::size_t cell);
  void move(const Step& step, const Motion& motion);
  void cut(const Step& step, const Motion& motion, std::uint64_t number);
  double corner_of(const Step& step, const LedPiece& piece, double tolerance) const;
  Feeds feeds(const Pace& pace, const MachinePath& path, const MotionTime& programmed, int pieces) const;
  void couple(const Step& step, const Motion& motion);
  void release();
  void smooth(const Step& step, const Motion& motion, std::uint64_t number);
  void end_smoothing();
  void add_thread(const Step& step, const Motion& motion, Spent spent);
  void cut_threads();
  void wait_for_spindle();
  void rest();
  TimedCells standing(const Axes& at, double seconds, Spent spent, double spindle);
  void stand(const Axes& at, double seconds, Spent spent);
  void hand_out(TimedCells& cells);
  void look_for_faults(const TimedCells& cells);

  AxisRoles roles_;
  double tolerance_;
  double dry_feed_ = 0;  // mm/min; 0: as programmed
  Axes rapid_{};         // mm/min or degrees/min
  Memory now_;
  Planner::Sink sink_;
  Planner planner_;
  Smoothing::Line line_;  // to the planner
  StopToken stop_;
};

}  // namespace kadr
