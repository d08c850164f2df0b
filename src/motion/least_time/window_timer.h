#pragma once
// WindowTimer: cells of a path → the same with their speed, window by window (motion/least_time/path_timer): what later cells cannot change
// any more is done. The second half of the planner; it may work in a thread of its own.

#include <cstdint>
#include <vector>

#include "motion/least_time/cell_cutter.h"
#include "motion/least_time/path_timer.h"

namespace kadr {

class WindowTimer {
 public:
  explicit WindowTimer(const MotionLimits& limits);

  /// Nothing is left: the axes stand.
  void begin();
  /// More cells, the last ones before the axes stand (`last`): what is done then is added to done().
  ///   post  with `last`: all is done. But where `stop` asked it to end, or the window is_refused(), then nothing may be made of it
  void take(const CutCells& more, bool last, StopToken stop);
  /// Hands out what was made elsewhere, if it is a plan. `standing`: s, about what it takes with a stop at each corner. `tag`: of where it
  /// begins.
  void hand_on(TimedCells made, double standing, std::uint64_t tag);

  /// No cell is kept, and the axes stand.
  bool is_at_rest() const { return now_.cells.count() == 0 && now_.ends.from_stop; }

  /// What is done and not fetched, in its order; the caller empties it.
  std::vector<TimedCells>& done() { return done_; }

  /// So many times what it takes with a stop at each corner no plan takes. One with a stop after each cell takes up to 50 times that: a
  /// cell is passed in 0.01 s at the feed v, from rest to rest with the jerk j in ∛(0.32 v/j) s. A speed that comes to nothing by rounding
  /// takes 10⁶ times that, or for ever.
  static constexpr double most_of_standing = 100;

  /// What it would not hand out, as it is no plan: mm of it, the tag of the cell that would have taken longest.
  struct Refused {
    double way = 0;
    std::uint64_t tag = 0;
  };
  bool is_refused() const { return now_.is_refused; }
  const Refused& refused() const { return now_.refused; }

  /// Stretches for which no speed was found, timed cell by cell with a stop after each (TimedCells::unsolved).
  std::size_t failures() const { return now_.failures; }
  /// What finding the speed took.
  const PathTimer::Work& work() const { return timer_.work(); }

  /// What it remembers: the cells that are not handed out yet.
  struct Memory {
    CutCells cells;
    PathEnds ends;
    std::size_t failures = 0;
    bool is_refused = false;
    Refused refused;
  };
  const Memory& memory() const { return now_; }
  void remember(const Memory& memory) { now_ = memory; }

 private:
  void solve(bool last, const StopToken& stop);
  std::size_t sure_cells() const;
  void hand_out(std::size_t count, bool stops = false);
  bool stop_where_known(const StopToken& stop);
  void cell_by_cell();
  double standing_of(std::size_t count) const;

  MotionLimits limits_;
  Memory now_;
  PathTimer timer_;
  std::vector<TimedCells> done_;
};

}  // namespace kadr
