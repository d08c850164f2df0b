#pragma once
// Planner: a path of straight pieces and stops → positions in time, with the least time that the axes' limits and the path's
// tolerances allow (mode `optimal` of a machine profile; the controls of old had nothing like it). Constant memory: it plans a
// window of the path, hands out what later pieces cannot change any more, and goes on from there.
//
//   pieces ─path/smooth/smooth_path─▶ smooth curve ─cell_cutter─▶ cells ─window_timer─▶ TimedCells
//
// Ahead of what is handed out: at most the way to stop, plus some thousand pieces. Smoothing and what comes after it may go on side by
// side; what comes out, and when, does not depend on which of them is quicker.

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

/// Why a planner hands out nothing more.
enum class PlanEnd : std::uint8_t {
  none,      // it does
  stopped,   // it was asked to
  enough,    // nobody looks at more
  too_slow,  // what it found is no plan: an error of its own
};

class Planner {
 public:
  using Sink = std::function<void(TimedCells&)>;  // it may add what it knows
  Planner(const MotionLimits& limits, Sink sink);

  /// Where the axes stand. Before anything else, and where they were moved by something else while they stood.
  void begin(const double* at);
  /// A straight piece. `feed`: mm/s along it, `tolerance`: of the corner at its beginning, mm; 0: exactly through it, so it stops there.
  /// `on_curve`: that corner is one of a chain of chords of a curve. `tag`: comes out with its cells.
  void line_to(const double* to, double feed, double tolerance, bool on_curve, std::uint64_t tag, bool paced = false);
  /// The axes come to rest; all is handed out.
  void stop();

  /// Plans whenever so many seconds of motion at the commanded feeds have come in, not only after some hundred pieces: for whoever waits
  /// for the first cells of long pieces. It costs some more plans.
  void plan_each(double seconds) { plan_each_ = seconds; }
  /// Cells are cut and timed in a thread of its own while the next pieces come in and are smoothed: they are handed out with the next plan.
  void work_side_by_side() { side_by_side_ = true; }
  /// Nothing is under way beside the caller: what is done is handed out. Before memory().
  void settle();
  /// Asked by all that may take long.
  void stop_by(StopToken stop) { stop_ = stop; }
  /// Nothing more is planned; the sink may say so too.
  void end_here() {
    if (now_.ended == PlanEnd::none) now_.ended = PlanEnd::enough;
  }
  /// From then on whatever comes in is passed over.
  PlanEnd ended() const { return now_.ended; }
  /// Where it ended by an error of its own.
  const WindowTimer::Refused& refused() const { return timer_.refused(); }

  static constexpr double most_of_standing = WindowTimer::most_of_standing;

  /// Stretches for which no speed was found, planned cell by cell with a stop after each (TimedCells::unsolved).
  std::size_t failures() const { return timer_.failures(); }

  /// What finding the speed took.
  const PathTimer::Work& work() const { return timer_.work(); }

 private:
  struct Path {
    explicit Path(std::size_t axes) : smooth(axes), at(axes) {}
    SmoothPath smooth;
    std::vector<double> at;   // the end of the last piece
    std::vector<double> way;  // of the last piece: its unit vector; empty: none yet
    std::size_t fresh = 0;    // pieces since the last plan
    double fresh_s = 0;       // s of them, at the commanded feeds
    PlanEnd ended = PlanEnd::none;
  };

 public:
  /// What it remembers from piece to piece: the window of the path that is not handed out yet.
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
  SmoothPath given_;  // a copy of the path, for who works beside
  StopToken stop_;
  double plan_each_ = 0;  // s; 0: by pieces alone
  bool side_by_side_ = false;
  SideBySide beside_;  // it works with cutter_, timer_, cut_, given_
};

}  // namespace kadr
