#pragma once
// CellCutter divides a smooth curve (path/smooth/smooth_path) into cells. In each cell the position of every axis is a polynomial of the
// fifth degree. The division does not depend on the speed of the axes in the cells, which is computed later.

#include <array>
#include <cstdint>
#include <vector>

#include "action/action.h"
#include "base/stop_token.h"
#include "motion/least_time/motion_limits.h"
#include "motion/least_time/timed_cells.h"
#include "motion/least_time/timed_path.h"
#include "path/smooth/smooth_path.h"

namespace kadr {

/// Cells whose geometry is computed but whose speed is not yet computed.
struct CutCells {
  TimedPath path;
  std::vector<CellSource> sources;
  // One time in s for each cell: the cell's part of the time that the path would take if the axes stopped at each corner.
  std::vector<double> standing;

  std::size_t count() const { return path.cells(); }
  void clear();
  /// Appends the cells of the list `more`.
  void append(const CutCells& more);
  /// Removes the first `count` cells.
  void forget(std::size_t count);
};

class CellCutter {
 public:
  explicit CellCutter(const MotionLimits& limits);

  /// Prepares the object for the first cell of a path.
  void begin();
  /// Divides the part of a path that later pieces cannot change into cells and appends them to `out`. With `last` the path is complete, so
  /// all of it is divided. If `stop` ends the work, the caller must not use the appended cells. `path` is in each call the same path or a
  /// copy of it, possibly extended since the last call.
  void cut(SmoothPath& path, bool last, StopToken stop, CutCells& out);

  bool has_cut() const { return cut_ > 0; }
  /// Returns the path length, mm, from which the path is still needed. The path before this length affects neither the rounding nor the
  /// size of later cells, so the caller may drop it.
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
  SmoothPath* path_ = nullptr;  // the path that cut() divides; set during cut() only
  Knot knot_;                   // end of the last cell; a knot is the boundary between two cells
  bool has_knot_ = false;
  double cut_ = 0;          // path length at the end of the last cell, mm
  std::size_t piece_ = 0;   // the path piece that contains the end of the last cell
  std::size_t passed_ = 0;  // number of pieces before `piece_`; the pieces that the path has dropped are included
  double needed_from_ = 0;
  struct {
    std::size_t piece = SIZE_MAX;
    double per_mm = 0;
  } standing_;  // time per length, s/mm, of a piece that the axes traverse with a stop at both ends; cached for the last used piece
};

}  // namespace kadr
