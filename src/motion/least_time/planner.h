#pragma once
// Planner: turns a path of straight pieces and stops into positions in time, with the least time that the axes' limits and the path's
// tolerances allow (mode `optimal` of a machine profile; older controls had nothing comparable). Memory is bounded: it plans a window of
// the path, emits what later pieces cannot change any more, and continues from there.
//
//   pieces ─path/smooth/smooth_path─▶ smooth curve ─cell_cutter─▶ cells ─window_timer─▶ TimedCells
//
// It looks ahead of the emitted cells by the stopping distance plus some thousand pieces at most. Smoothing and the later stages may run
// in parallel; what is emitted, and at which input, does not depend on which of them is faster.

#include <cstdint>
#include <functional>
#include <vector>

#include "base/side_by_side.h"
#include "base/stop.h"
#include "motion/least_time/cell_cutter.h"
#include "motion/least_time/motion_limits.h"
#include "motion/least_time/timed_cells.h"
#include "motion/least_time/window_timer.h"

namespace kadr {

/// Why a planner emits nothing more.
enum class PlanEnd : std::uint8_t {
  none,      // it still emits
  stopped,   // it was stopped from outside
  enough,    // the receiver needs no more
  too_slow,  // the result is not a valid plan: an error of the planner
};

class Planner {
 public:
  using Sink = std::function<void(TimedCells&)>;  // may complete the cells with its own data
  Planner(const MotionLimits& limits, Sink sink);

  /// Sets the position of the axes at rest. Call it first, and whenever something else has moved the axes while they were at rest.
  void begin(const double* at);
  /// Adds a straight piece. `feed`: mm/s along it. `tolerance`: of the corner at its start, mm; 0: exactly through the corner, so the
  /// axes stop there. `on_curve`: that corner lies between two chords of a curve. `tag`: is copied to the piece's cells.
  void line_to(const double* to, double feed, double tolerance, bool on_curve, std::uint64_t tag, bool paced = false);
  /// Brings the axes to rest and emits everything.
  void stop();

  /// Plans whenever pieces with this many seconds of motion at the commanded feeds have arrived, not only after some hundred pieces. For
  /// callers that need the first cells of long pieces early; it costs additional plans.
  void plan_each(double seconds) { plan_each_ = seconds; }
  /// Cuts and times cells in a separate thread while further pieces arrive and are smoothed: the cells are emitted with the next plan.
  void work_side_by_side() { side_by_side_ = true; }
  /// Waits for the separate thread and emits what is done. Call it before memory().
  void settle();
  /// Sets the token that all long computations check.
  void stop_by(StopToken stop) { stop_ = stop; }
  /// Ends planning; the sink may call it too.
  void end_here() {
    if (now_.ended == PlanEnd::none) now_.ended = PlanEnd::enough;
  }
  /// Returns why planning has ended; from then on all input is ignored.
  PlanEnd ended() const { return now_.ended; }
  /// Returns the segment at which planning ended because of an error of the planner.
  const WindowTimer::Refused& refused() const { return timer_.refused(); }

  static constexpr double most_of_standing = WindowTimer::most_of_standing;

  /// Returns the number of segments for which no speed was found; they are planned cell by cell with a stop after each
  /// (TimedCells::unsolved).
  std::size_t failures() const { return timer_.failures(); }

  /// Statistics of the solvers.
  const PathTimer::Work& work() const { return timer_.work(); }

 private:
  struct Path {
    explicit Path(std::size_t axes) : smooth(axes), at(axes) {}
    SmoothPath smooth;
    std::vector<double> at;   // the end of the last piece
    std::vector<double> way;  // direction of the last piece, a unit vector; empty: none yet
    std::size_t fresh = 0;    // pieces since the last plan
    double fresh_s = 0;       // s, the time of these pieces at the commanded feeds
    PlanEnd ended = PlanEnd::none;
  };

 public:
  /// The state that it keeps from piece to piece: the window of the path that is not emitted yet.
  struct Memory {
    Path path;
    CellCutter cutter;
    WindowTimer::Memory window;
  };
  Memory memory() const { return {now_, cutter_, timer_.memory()}; }
  void remember(const Memory& memory);

 private:
  bool turns(const double* to) const;
  bool is_due() const;
  void plan(bool last);
  void time_cells(SmoothPath& path, bool last);
  void fetch();
  void straight_line();
  bool halted();

  std::size_t axes_;
  MotionLimits limits_;
  Sink sink_;
  Path now_;
  CellCutter cutter_;
  WindowTimer timer_;
  CutCells cut_;
  SmoothPath given_;  // a copy of the path, for the separate thread
  StopToken stop_;
  double plan_each_ = 0;  // s; 0: only the number of pieces counts
  bool side_by_side_ = false;
  SideBySide beside_;  // uses cutter_, timer_, cut_, given_
};

}  // namespace kadr
