#pragma once
// CellCutter: divides a smooth curve (path/smooth/smooth_path) into cells, in each of which every axis is a polynomial of the fifth
// degree. It does not depend on how fast the cells are passed.

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

/// Cells that are cut but whose speed is not found yet.
struct CutCells {
  TimedPath path;
  std::vector<CellSource> sources;
  std::vector<double> standing;  // s, for each cell: its share of the time that the path takes with a stop at each corner

  std::size_t count() const { return path.cells(); }
  void clear();
  /// Appends the cells of `more`.
  void append(const CutCells& more);
  /// Drops the first `count` cells.
  void forget(std::size_t count);
};

class CellCutter {
 public:
  explicit CellCutter(const MotionLimits& limits);

  /// Prepares for the first cell of a path.
  void begin();
  /// Cuts a path as far as it is settled; all of it, if this is its end (`last`). The cells are appended to `out`; if `stop` ends the
  /// work, they are of no use. `path`: the same path with each call, extended since, or a copy of it.
  void cut(SmoothPath& path, bool last, StopToken stop, CutCells& out);

  bool has_cut() const { return cut_ > 0; }
  /// Returns the length from which on the path is still needed: what lies before affects neither the rounding nor the size of a further
  /// cell.
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
  SmoothPath* path_ = nullptr;  // set during cut()
  Knot knot_;                   // the last knot
  bool has_knot_ = false;
  double cut_ = 0;          // length of the path at the last knot
  std::size_t piece_ = 0;   // the piece that contains the last knot
  std::size_t passed_ = 0;  // pieces before it, including those that the path has forgotten
  double needed_from_ = 0;
  struct {
    std::size_t piece = SIZE_MAX;
    double per_mm = 0;
  } standing_;  // s per mm of this piece with a stop at both ends: cached for the piece used last
};

}  // namespace kadr
