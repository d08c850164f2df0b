#pragma once
// AxisMotion: converts Steps into the axes' motion in time with the Planner. AxisMotion computes the curve of each motion in machine
// coordinates, the positions at which the axes stop, and the duration of pauses. Threads and rigid tapping are synchronised with the
// spindle; the output contains the spindle angle.

#include <deque>
#include <functional>

#include "config/machine/machine_profile.h"
#include "config/setup/setup.h"
#include "motion/least_time/planner.h"
#include "motion/least_time/smoothing.h"
#include "motion/least_time/tcp_corner.h"
#include "motion/least_time/thread_chain.h"
#include "motion/time/estimate.h"
#include "motion/time/pace.h"
#include "motion/time/spindle_clock.h"
#include "path/curve/machine_path.h"

namespace kadr {

/// Returns the axis limits that the machine profile and the set-up state; the set-up has priority.
MotionLimits motion_limits(const MachineProfile& profile, const Setup& setup, const std::vector<std::string>& axes);

/// The activity that time is spent on (cutting, rapid, dwell, tool change), and the program line that causes it. tag() packs both into
/// the 64-bit tag of a cell.
struct Spent {
  enum class On : std::uint8_t { cutting, rapid, dwell, tool_change };
  On on = On::cutting;
  std::uint32_t line = 0;
  std::uint16_t file = 0;  // program file of `line`, numbered as in Origin::file
  std::uint64_t tag() const { return std::uint64_t{line} << 32 | std::uint64_t{file} << 16 | static_cast<std::uint64_t>(on); }
  static Spent of(std::uint64_t tag) {
    return {static_cast<On>(tag & 0xFF), static_cast<std::uint32_t>(tag >> 32), static_cast<std::uint16_t>(tag >> 16 & 0xFFFF)};
  }
};

/// Faults of the finished plan: segments without a solution, and positions where the path exceeds its tolerance.
struct PlanFaults {
  std::size_t unsolved = 0;    // number of segments for which no speed was found (TimedCells::unsolved)
  double unsolved_length = 0;  // mm, total length of those segments
  Spent unsolved_at;           // activity and program line of the first such segment
  double beyond = 0;           // greatest excess of the path's deviation over the tolerance, as a share of the tolerance
  Spent beyond_at;             // activity and program line where the deviation first exceeds the tolerance
};

/// mm/s: the feed used for a motion whose programmed time is unknown (override 0, spindle at rest).
inline constexpr double unlimited_feed = 1e6;

class AxisMotion {
 public:
  /// `tolerance`: corner tolerance, mm, for corners for which the program states no tolerance.
  AxisMotion(const AxisRoles& roles, const MotionLimits& limits, double tolerance, const ToolPosition& start, Planner::Sink sink);
  AxisMotion(const AxisMotion&) = delete;  // the planner holds a pointer to this object
  AxisMotion& operator=(const AxisMotion&) = delete;

  /// Sets the main spindle's rotation at the program start, and the smoothing parameters (G5.1).
  void start(const Setup& setup, const std::vector<std::string>& axes);

  /// Called for each motion before it is planned. `number`: the motion's number (CellSource::motion of its cells); `way`: the approximate
  /// total length of its cells, mm.
  std::function<void(std::uint64_t number, double way)> on_motion;

  /// Called for each motion before it is planned. `number`: the motion's number; `from`: its start position and coordinate frame.
  std::function<void(std::uint64_t number, const ToolPosition& from)> on_place;

  /// Plans a step. The step must already have its time at the programmed feed.
  void consume(const Step& step);
  /// Ends the motion with the axes at rest and emits all cells.
  void finish() { rest(); }

  /// Starts a plan after each `seconds` of motion, see Planner::plan_each().
  void plan_each(double seconds) { planner_.plan_each(seconds); }
  /// Plans in a separate thread, and waits for that thread: see Planner::work_in_background(), Planner::settle().
  void work_in_background() { planner_.work_in_background(); }
  void settle() { planner_.settle(); }
  /// Dry run: replaces all feeds, except thread feeds, by `feed`, mm/min; 0 restores the programmed feeds.
  void run_dry(double feed) { dry_feed_ = feed; }

  /// Sets the token that all long computations check.
  void stop_by(StopToken stop);
  /// Returns why planning has ended. After planning has ended, all actions are ignored.
  PlanEnd ended() const { return planner_.ended(); }
  /// Ends planning because no more cells are needed, see Planner::end_here().
  void end_here() { planner_.end_here(); }
  const PlanFaults& faults() const { return now_.faults; }
  /// The segment that the planner did not emit because of a planner error: its length, and the activity and program line of the cell that
  /// would have taken longest.
  struct Refused {
    double way = 0;  // length of the refused segment, mm
    Spent at;
  };
  Refused refused() const;

 private:
  /// A motion whose cells are not all emitted yet.
  struct Record {
    std::uint64_t motion, spent;
    Switches switches;
    SpindleTurning spindle;
    double spindle_part;  // spindle override as a share (1: 100 %)
    // work coordinate minus machine coordinate, mm, of the axis whose position sets the spindle speed at constant surface speed
    double shift;
  };

 public:
  /// The state that AxisMotion keeps between steps. A copy is valid only after settle().
  struct Memory {
    explicit Memory(const MotionLimits& limits) : threads(limits) {}
    std::deque<Record> records;
    std::uint64_t motions = 0;
    bool exact = true;  // true if the last motion ended with an exact stop, so that the corner after it is not rounded
    TcpPiece led;       // the straight piece planned last, if tool centre point control was active in it
    SpindleClock spindle;
    Smoothing smoothing;
    ThreadChain threads;  // consecutive threads that are not planned yet
    Spent thread_spent;   // activity and program line of the first thread in `threads`
    PlanFaults faults;
    double thread_angle = 0;  // spindle angle at which the next thread starts, degrees since a zero pulse
  };
  struct Snapshot {
    Memory own;
    Planner::Memory planner;
  };
  Snapshot snapshot() const { return {now_, planner_.memory()}; }
  void restore(const Snapshot& from) { now_ = from.own, planner_.resume_from(from.planner); }

 private:
  /// The length of a motion, mm, and the speed in each of its pieces, mm/s. The last speed also applies to all pieces beyond the list.
  struct Feeds {
    double length;
    std::vector<double> speeds;
  };
  std::uint64_t record(Spent spent, Switches switches, const Motion& motion);
  static double spindle_rate(const Record& record, const TimedCells& cells, std::size_t cell);
  void move(const Step& step, const Motion& motion);
  void cut(const Step& step, const Motion& motion, std::uint64_t number);
  double corner_of(const Step& step, const TcpPiece& piece, double tolerance) const;
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
  void deliver(TimedCells& cells);
  void look_for_faults(const TimedCells& cells);

  AxisRoles roles_;
  double tolerance_;
  double dry_feed_ = 0;  // feed of a dry run, mm/min; 0: feeds as programmed
  Axes rapid_{};         // rapid rates of the axes, mm/min or degrees/min
  Memory now_;
  Planner::Sink sink_;
  Planner planner_;
  Smoothing::Line line_;  // passes the lines that Smoothing emits to the planner
  StopToken stop_;
};

}  // namespace kadr
