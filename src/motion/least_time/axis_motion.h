#pragma once
// AxisMotion converts Steps into the axes' motion in time with the Planner. It computes the curve of each motion in machine coordinates,
// the positions at which the axes stop, and the duration of pauses. Threads and rigid tapping are synchronised with the spindle, so the
// output contains the spindle angle.

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

/// Returns the axis limits that the machine profile and the set-up state; the set-up has priority over the profile.
MotionLimits motion_limits(const MachineProfile& profile, const Setup& setup, const std::vector<std::string>& axes);

/// The activity that the time is spent on (cutting, rapid, dwell, tool change) and the program line that causes it. tag() stores both in
/// the 64-bit tag of a cell.
struct Spent {
  enum class On : std::uint8_t { cutting, rapid, dwell, tool_change };
  On on = On::cutting;
  std::uint32_t line = 0;
  std::uint16_t file = 0;  // the program file that contains `line`, numbered as in Origin::file
  std::uint64_t tag() const { return std::uint64_t{line} << 32 | std::uint64_t{file} << 16 | static_cast<std::uint64_t>(on); }
  static Spent of(std::uint64_t tag) {
    return {static_cast<On>(tag & 0xFF), static_cast<std::uint32_t>(tag >> 32), static_cast<std::uint16_t>(tag >> 16 & 0xFFFF)};
  }
};

/// Faults of the finished plan: segments without a solution, and positions at which the path exceeds its tolerance.
struct PlanFaults {
  std::size_t unsolved = 0;    // number of segments for which no speed was found (TimedCells::unsolved)
  double unsolved_length = 0;  // total length of the segments without a speed, mm
  Spent unsolved_at;           // activity and program line of the first segment without a speed
  double beyond = 0;           // the greatest excess of the path's deviation over the tolerance, as a fraction of the tolerance
  Spent beyond_at;             // activity and program line at which the deviation first exceeds the tolerance
};

/// Feed, mm/s, of a motion whose programmed time is unknown because the override is 0 or the spindle is at rest.
inline constexpr double unlimited_feed = 1e6;

class AxisMotion {
 public:
  /// `tolerance` is the corner tolerance in mm. It applies to corners for which the program states no tolerance.
  AxisMotion(const AxisRoles& roles, const MotionLimits& limits, double tolerance, const ToolPosition& start, Planner::Sink sink);
  /// Changes the position at which the motion starts. To be called before the first step.
  void begin_at(const ToolPosition& start);
  AxisMotion(const AxisMotion&) = delete;  // Copying is disabled because the planner stores a pointer to this object.
  AxisMotion& operator=(const AxisMotion&) = delete;

  /// Sets the rotation of the spindles at the program start, their highest speed in rev/min, and the parameters of smoothing (G5.1).
  void start(const Setup& setup, const std::vector<std::string>& axes, double most_rpm = SpindleTurning::fastest);

  /// A function of the client that AxisMotion calls for each motion before it plans the motion. `number` is the motion's number; the cells
  /// of the motion have this number as CellSource::motion. `length` is the approximate total length of these cells in mm.
  std::function<void(std::uint64_t number, double length)> on_motion;

  /// A function of the client that receives where each motion starts; AxisMotion calls it before it plans the motion. `number` is the
  /// motion's number; `from` has its start position and coordinate frame.
  std::function<void(std::uint64_t number, const ToolPosition& from)> on_place;

  /// Plans a step. The step must already have the time that it takes at the programmed feed.
  void consume(const Step& step);
  /// Plans the rest of the motion until the axes are at rest and emits all cells.
  void finish() { rest(); }

  /// Starts a plan after each `seconds` of motion; see Planner::plan_each().
  void plan_each(double seconds) { planner_.plan_each(seconds); }
  /// Plans in a separate thread; see Planner::work_in_background(). settle() waits for that thread; see Planner::settle().
  void work_in_background() { planner_.work_in_background(); }
  void settle() { planner_.settle(); }
  /// Dry run: replaces all feeds except thread feeds by `feed`, mm/min. The value 0 restores the programmed feeds.
  void run_dry(double feed) { dry_feed_ = feed; }
  /// Scales the feeds of the motions that are consumed from now on, 1: as programmed. Thread feeds and a dry run stay as they are. Limits
  /// of the axes apply to the scaled feed.
  void scale_feed(double factor) { feed_factor_ = factor; }
  /// True if the feed of the motion can be scaled: not in rapid motion, probing, and thread cutting.
  static bool has_override(const Motion& motion) {
    return motion.kind == MotionKind::feed || is_arc(motion.kind) || motion.kind == MotionKind::spline;
  }

  /// Sets the stop token that all long computations poll.
  void stop_by(StopToken stop);
  /// Returns why planning has ended. After the end of planning the object ignores all actions.
  PlanEnd ended() const { return planner_.ended(); }
  /// Ends planning because the caller needs no more cells; see Planner::end_here().
  void end_here() { planner_.end_here(); }
  const PlanFaults& faults() const { return now_.faults; }
  /// The segment that the planner did not emit because of a planner error. `at` is the activity and the program line of the cell that would
  /// have taken the longest time.
  struct Refused {
    double length = 0;  // length of the segment that was not emitted, mm
    Spent at;
  };
  Refused refused() const;

 private:
  /// A motion whose cells are not all emitted yet.
  struct Record {
    std::uint64_t motion, spent;
    Switches switches;
    SpindleTurning spindle;
    double spindle_part;  // spindle override as a factor (1: 100 %)
    // Work coordinate minus machine coordinate, mm, of the axis whose position determines the spindle speed at constant surface speed.
    double shift;
  };

 public:
  /// The state that AxisMotion keeps between steps. Call settle() before making a copy; otherwise the copy is not valid.
  struct Memory {
    explicit Memory(const MotionLimits& limits) : threads(limits) {}
    std::deque<Record> records;
    std::uint64_t motions = 0;
    bool exact = true;  // True if the last motion ended with an exact stop. The corner after this motion is then not rounded.
    TcpPiece led;       // the last planned piece, if tool centre point control was active in this piece
    SpindleClock spindle;
    Smoothing smoothing;
    ThreadChain threads;  // consecutive thread-cutting motions that the planner has not planned yet
    Spent thread_spent;   // activity and program line of the first thread-cutting motion in `threads`
    PlanFaults faults;
    double thread_angle = 0;  // spindle angle at which the next thread-cutting motion starts, in degrees after a zero pulse
  };
  struct Snapshot {
    Memory own;
    Planner::Memory planner;
  };
  Snapshot snapshot() const { return {now_, planner_.memory()}; }
  void restore(const Snapshot& from) { now_ = from.own, planner_.resume_from(from.planner); }

 private:
  /// The length of a motion, mm, and the speed in each of its pieces, mm/s. If there are more pieces than speeds, the last speed applies to
  /// the remaining pieces.
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
  double dry_feed_ = 0;     // feed of a dry run, mm/min; 0: the programmed feeds apply
  double feed_factor_ = 1;  // factor of the programmed feeds, see scale_feed()
  Axes rapid_{};            // rapid rates of the axes, mm/min or degrees/min
  Memory now_;
  Planner::Sink sink_;
  Planner planner_;
  Smoothing::Line line_;  // function that passes the lines which Smoothing emits to the planner
  StopToken stop_;
};

}  // namespace kadr
