#pragma once
// WindowTimer finds the speed of a path's cells, window by window (motion/least_time/path_timer), and emits the cells that later cells
// cannot change any more. WindowTimer is the second half of the planner and may run in its own thread.

#include <cstdint>
#include <vector>

#include "motion/least_time/cell_cutter.h"
#include "motion/least_time/path_timer.h"

namespace kadr {

class WindowTimer {
 public:
  explicit WindowTimer(const MotionLimits& limits);

  /// Removes all cells. The axes must be at rest.
  void begin();
  /// Accepts more cells and appends to done() the cells that are then finished. `last` is true if the axes are at rest after the last cell
  /// of `more`.
  ///   post  with `last`, all cells are in done(); but done() is not valid if `stop` ended the work or is_refused() is true
  void take(const CutCells& more, bool last, StopToken stop);
  /// Adds a plan that was computed elsewhere to done(), or refuses the plan. `standing` is the approximate time with a stop at each corner,
  /// s. `tag` is the tag at the start of the plan.
  void pass_cells_on(TimedCells made, double standing, std::uint64_t tag);

  /// True if no cell is waiting and the axes are at rest.
  bool is_at_rest() const { return now_.cells.count() == 0 && now_.ends.from_stop; }

  /// The finished cells that the caller has not fetched yet, in their order. The caller must empty the vector.
  std::vector<TimedCells>& done() { return done_; }

  /// A plan is refused if it takes more than this multiple of the time with a stop at each corner. A plan with a stop after each cell takes
  /// up to 50 times the time with a stop at each corner: a cell takes 0.01 s at the feed v, but ∛(0.32 v/j) s from rest to rest with the
  /// jerk j. If rounding errors have reduced a speed to nearly 0, the plan takes 10⁶ times that time, or it never ends.
  static constexpr double most_of_standing = 100;

  /// The refused plan. `length` is its length in mm, and `tag` is the tag of the cell that would have taken the longest time.
  struct Refused {
    double length = 0;
    std::uint64_t tag = 0;
  };
  bool is_refused() const { return now_.is_refused; }
  const Refused& refused() const { return now_.refused; }

  /// Number of segments for which no speed was found. In these segments the axes stop after each cell (TimedCells::unsolved).
  std::size_t failures() const { return now_.failures; }
  /// Statistics of the solvers.
  const PathTimer::Work& work() const { return timer_.work(); }

  /// The state that WindowTimer keeps between calls: the cells that are not emitted yet.
  struct Memory {
    CutCells cells;
    PathEnds ends;
    std::size_t failures = 0;
    bool is_refused = false;
    Refused refused;
  };
  const Memory& memory() const { return now_; }
  void resume_from(const Memory& memory) { now_ = memory; }

 private:
  void solve(bool last, const StopToken& stop);
  std::size_t sure_cells() const;
  void deliver(std::size_t count, bool stops = false);
  bool stop_where_known(const StopToken& stop);
  void cell_by_cell();
  double standing_of(std::size_t count) const;

  MotionLimits limits_;
  Memory now_;
  PathTimer timer_;
  std::vector<TimedCells> done_;
};

}  // namespace kadr
