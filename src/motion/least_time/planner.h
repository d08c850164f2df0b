#pragma once
// The Planner converts a path of straight pieces and stops into positions in time. The motion takes the least time that the axes' limits
// and the path's tolerances allow (mode `optimal` of a machine profile; older controls have no such mode). Memory is bounded: the planner
// plans a window of the path, emits the cells that later pieces cannot change any more, and continues after these cells.
//
//   pieces ─path/smooth/smooth_path─▶ smooth curve ─cell_cutter─▶ cells ─window_timer─▶ TimedCells
//
// The planner looks ahead of the emitted cells by at most the stopping distance plus some thousand pieces. Smoothing and the later stages
// may run in parallel. The emitted cells, and the input piece at which the planner emits them, do not depend on the speed of the two
// threads.

#include <cstdint>
#include <functional>
#include <vector>

#include "base/background_worker.h"
#include "base/stop_token.h"
#include "motion/least_time/cell_cutter.h"
#include "motion/least_time/motion_limits.h"
#include "motion/least_time/timed_cells.h"
#include "motion/least_time/window_timer.h"

namespace kadr {

/// The reason why a planner has stopped emitting cells before the end of the path.
enum class PlanEnd : std::uint8_t {
  none,      // planning has not ended
  stopped,   // the stop token ended planning
  enough,    // The receiver has called end_here(), because it needs no more cells.
  too_slow,  // The planned time is impossibly long (most_of_standing) because of an error of the planner.
};

class Planner {
 public:
  // The type of the receiver of finished cells. The receiver may add its own data to the cells.
  using Sink = std::function<void(TimedCells&)>;
  Planner(const MotionLimits& limits, Sink sink);

  /// Sets the position `at` at which the axes are at rest. Call begin() before the first piece, and again whenever something other than
  /// this planner has moved the axes.
  void begin(const double* at);
  /// Adds a straight piece to the position `to`. `feed` is the speed along the piece in mm/s. `tolerance` is how far the corner at the
  /// start of the piece may be rounded, mm; 0 means that the axes stop at the corner. `on_curve` is true if this corner lies between two
  /// chords of a curve. `tag` is copied to the cells of the piece. `paced` is true if the feed changes smoothly from the feed of the
  /// previous piece to the feed of this piece.
  void line_to(const double* to, double feed, double tolerance, bool on_curve, std::uint64_t tag, bool paced = false);
  /// Plans the rest of the path until the axes are at rest and emits all cells.
  void stop();

  /// Makes the planner start a plan also when the pieces received since the last plan take `seconds` at their commanded feeds, and not only
  /// after about a thousand pieces. Callers that need the first cells of long pieces early use this function; the cost is additional plans.
  void plan_each(double seconds) { plan_each_ = seconds; }
  /// Makes the planner cut and time cells in a separate thread while further pieces arrive and are smoothed. The planner emits the cells of
  /// a plan at the next plan.
  void work_in_background() { in_background_ = true; }
  /// Waits for the separate thread and emits its finished cells. Call settle() before memory().
  void settle();
  /// Sets the stop token that all long computations poll.
  void stop_by(StopToken stop) { stop_ = stop; }
  /// Ends planning. The sink may call this function too.
  void end_here() {
    if (now_.ended == PlanEnd::none) now_.ended = PlanEnd::enough;
  }
  /// Returns why planning has ended. After the end of planning the planner ignores all input.
  PlanEnd ended() const { return now_.ended; }
  /// Returns the segment at which an error of the planner ended planning.
  const WindowTimer::Refused& refused() const { return timer_.refused(); }

  static constexpr double most_of_standing = WindowTimer::most_of_standing;

  /// Returns the number of segments for which no speed was found. In these segments the axes stop after each cell (TimedCells::unsolved).
  std::size_t failures() const { return timer_.failures(); }

  /// Statistics of the solvers.
  const PathTimer::Work& work() const { return timer_.work(); }

 private:
  struct Path {
    explicit Path(std::size_t axes) : smooth(axes), at(axes) {}
    SmoothPath smooth;
    std::vector<double> at;         // axis positions at the end of the last piece, mm or degrees
    std::vector<double> direction;  // direction of the last piece, a unit vector; empty before the first piece
    std::size_t fresh = 0;          // number of pieces received since the last plan
    double fresh_s = 0;             // time, at the commanded feeds, of the pieces received since the last plan, s
    PlanEnd ended = PlanEnd::none;
  };

 public:
  /// The state that the planner keeps between pieces: the part of the path that is not emitted yet.
  struct Memory {
    Path path;
    CellCutter cutter;
    WindowTimer::Memory window;
  };
  Memory memory() const { return {now_, cutter_, timer_.memory()}; }
  void resume_from(const Memory& memory);

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
  SmoothPath given_;  // copy of the path that the separate thread uses
  StopToken stop_;
  double plan_each_ = 0;  // time of motion between two plans, s; 0: only the number of pieces starts a plan
  bool in_background_ = false;
  BackgroundWorker background_;  // The separate thread of execution that cuts and times cells. It uses cutter_, timer_, cut_ and given_.
};

}  // namespace kadr
