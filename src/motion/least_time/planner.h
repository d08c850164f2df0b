#pragma once
// Planner: a path of straight pieces and stops → positions in time, with the least time that the axes' limits and the path's
// tolerances allow (mode `optimal` of a machine profile; the controls of old had nothing like it). Constant memory: it plans a
// window of the path, hands out what later pieces cannot change any more, and goes on from there.
//
//   pieces ─path/smooth/smooth_path─▶ smooth curve ─cells─▶ motion/least_time/path_timer ─▶ TimedCells
//
// Ahead of what is handed out: at most the way to stop, plus some hundred pieces.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "action/action.h"
#include "base/stop.h"
#include "motion/least_time/path_timer.h"
#include "motion/least_time/rest_to_rest.h"
#include "motion/least_time/timed_cells.h"
#include "path/smooth/smooth_path.h"

namespace kadr {

/// Limits of each axis: mm/s, mm/s², mm/s³ (of rotary ones degrees); all above 0 and finite.
struct MotionLimits {
  std::vector<double> speed, acceleration, jerk;
};

/// Why a planner hands out nothing more.
enum class PlanEnd : std::uint8_t {
  none,      // it does
  stopped,   // it was asked to
  too_slow,  // what it found is no plan: an error of its own
};

class Planner {
 public:
  using Sink = std::function<void(TimedCells&)>;  // it may add what it knows
  Planner(MotionLimits limits, Sink sink);

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
  /// Asked by all that may take long.
  void stop_by(StopToken stop) { stop_ = stop; }
  /// From then on whatever comes in is passed over.
  PlanEnd ended() const { return now_.ended; }
  /// Where it ended by an error of its own: mm of the path that were not handed out then, and the tag of the piece that would have taken
  /// longest.
  struct Refused {
    double way = 0;
    std::uint64_t tag = 0;
  };
  const Refused& refused() const { return now_.refused; }

  /// So many times what it takes with a stop at each corner no plan takes. One with a stop after each cell takes up to 50 times that: a
  /// cell is passed in 0.01 s at the feed v, from rest to rest with the jerk j in ∛(0.32 v/j) s. A speed that comes to nothing by rounding
  /// takes 10⁶ times that, or for ever.
  static constexpr double most_of_standing = 100;

  /// Stretches for which no speed was found, planned cell by cell with a stop after each (TimedCells::unsolved).
  std::size_t failures() const { return now_.failures; }

  /// What finding the speed took.
  const PathTimer::Work& work() const { return timer_.work(); }

  /// What it remembers from piece to piece: the window of the path that is not handed out yet.
  struct Memory {
    explicit Memory(std::size_t axes) : path(axes) {}
    SmoothPath path;
    std::vector<double> at;   // the end of the last piece
    std::vector<double> way;  // of the last piece: its unit vector; empty: none yet
    std::size_t fresh = 0;    // pieces since the last plan
    double fresh_s = 0;       // s of them, at the commanded feeds
    // cells not yet handed out
    TimedPath cells;
    std::vector<CellSource> sources;
    struct Knot {
      std::array<double, max_axes> x{}, x1{}, x2{};
    } knot;  // the last one
    bool has_knot = false;
    double cut = 0;         // length at the last knot
    std::size_t piece = 0;  // that holds it
    PathEnds ends;
    std::size_t failures = 0;
    PlanEnd ended = PlanEnd::none;
    Refused refused;
  };
  const Memory& memory() const { return now_; }
  void remember(const Memory& memory) { now_ = memory; }

 private:
  bool turns(const double* to) const;
  bool is_due() const;
  void plan(bool last);
  void cut_cells(bool last);
  double ramp_s(double speed) const;
  double size_at(double s, std::size_t piece, bool last, double curve_part) const;
  double size_in_chain(double s, std::size_t piece, double reach) const;
  bool is_even(double h);
  bool feed_changes(std::size_t vertex) const;
  double room_at_feed_change(std::size_t vertex) const;
  double next_size(bool last);
  Bend bend_at(double to, std::size_t end_piece) const;
  double feed_between(double from, double to) const;
  double draw_cell(double to, std::size_t end_piece, double* c, Memory::Knot& end);
  double add_cell(double to, double least, bool turns);
  void set_knot(double s, std::size_t piece);
  void solve(bool last);
  void hand_out(std::size_t cells, bool stops = false);
  bool stop_where_known();
  void straight_line();
  void cell_by_cell();
  bool halted();
  double standing_s(double from, double to) const;
  void hand_on(double from, double to);
  double way_of_cells() const;
  double beyond(const double* c, double to, std::size_t last_piece) const;
  LineLimits limits_along(const double* way, double feed) const;
  std::size_t sure_cells() const;

  MotionLimits limits_;
  Sink sink_;
  Memory now_;
  PathTimer timer_;
  TimedCells out_;
  StopToken stop_;
  double plan_each_ = 0;  // s; 0: by pieces alone
};

}  // namespace kadr
