#pragma once
// CellCutter: a smooth curve (path/smooth/smooth_path) → cells, in each of which every axis is a polynomial of the fifth degree. It knows
// nothing of how fast they are passed.

#include <array>
#include <cstdint>
#include <vector>

#include "action/action.h"
#include "base/stop.h"
#include "motion/least_time/motion_limits.h"
#include "motion/least_time/timed_cells.h"
#include "motion/least_time/timed_path.h"
#include "path/smooth/smooth_path.h"

namespace kadr {

/// Cells that are cut and whose speed is not found yet.
struct CutCells {
  TimedPath path;
  std::vector<CellSource> sources;
  std::vector<double> standing;  // s: of each cell, its part of what the path takes with a stop at each corner

  std::size_t count() const { return path.cells(); }
  void clear();
  /// Those of `more` behind these.
  void append(const CutCells& more);
  /// The first ones.
  void forget(std::size_t count);
};

class CellCutter {
 public:
  explicit CellCutter(const MotionLimits& limits);

  /// Before the first cell of a path.
  void begin();
  /// Cuts a path as far as it is settled; all of it, if this is its end (`last`). The cells are added to `out`; asked to stop, they are of
  /// no use. `path`: with each call the same one, gone on, or a copy of it.
  void cut(SmoothPath& path, bool last, StopToken stop, CutCells& out);

  bool has_cut() const { return cut_ > 0; }
  /// What of the path lies before this length changes nothing any more: neither the rounding nor the size of a cell.
  double needed_from() const { return needed_from_; }

 private:
  struct Knot {
    std::array<double, max_axes> x{}, x1{}, x2{};
  };

  double ramp_s(double speed) const;
  double size_at(double s, std::size_t piece, bool last, double curve_part) const;
  double size_in_chain(double s, std::size_t piece, double reach) const;
  bool is_even(double h);
  bool feed_changes(std::size_t vertex) const;
  double room_at_feed_change(std::size_t vertex) const;
  double next_size(bool last);
  Bend bend_at(double to, std::size_t end_piece) const;
  double feed_between(double from, double to) const;
  double draw_cell(double to, std::size_t end_piece, double* c, Knot& end);
  double add_cell(double to, double least, bool turns, CutCells& out);
  void divide(double width, CutCells& out) const;
  double most_in(const double* c, double h, double feed) const;
  double standing_s(double from, double to, std::size_t piece);
  void set_knot(double s, std::size_t piece);
  double beyond(const double* c, double to, std::size_t last_piece) const;

  std::size_t axes_;
  MotionLimits limits_;
  SmoothPath* path_ = nullptr;  // while it is cut
  Knot knot_;                   // the last one
  bool has_knot_ = false;
  double cut_ = 0;          // length at the last knot
  std::size_t piece_ = 0;   // that holds it
  std::size_t passed_ = 0;  // pieces before it, those that the path has forgotten too
  double needed_from_ = 0;
  struct {
    std::size_t piece = SIZE_MAX;
    double per_mm = 0;
  } standing_;  // s for each mm of a piece with a stop at both ends: the one asked for last
};

}  // namespace kadr
