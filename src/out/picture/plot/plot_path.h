#pragma once
// PlotPath: stores a path as a polyline with a limited number of points. When the limit is reached, points are removed with an increasing
// tolerance.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "out/picture/canvas.h"
#include "out/text/extents.h"

namespace kadr {

/// Types of stroke. plunge: a feed motion straight down; contour: the programmed contour; jump: no stroke is drawn, since the path
/// continues at another position.
enum class Stroke : std::uint8_t { rapid, feed, plunge, arc, contour, probe, jump };
inline bool cuts(Stroke stroke) { return stroke != Stroke::rapid && stroke != Stroke::probe && stroke != Stroke::jump; }

/// A vertex of the polyline, and the type of the stroke that ends there.
struct PlotPoint {
  Vec3 at;
  Stroke stroke;
  float shade = 0;  // speed in mm/min or number of a limit, which selects the colour; see out/picture/plot/plot_shades
  ProgramLine line{};
};

class PlotPath {
 public:
  /// Creates an empty path, which stores at most `most` points.
  explicit PlotPath(std::size_t most = 100'000) : most_(most) {}

  void start(Vec3 at);
  void go(Vec3 to, Stroke stroke, float shade = 0, ProgramLine line = {});
  /// Extends the box of the path by this box. A caller passes the box of a curve, since the curve may extend beyond its chords.
  void reach(const Box& box, Stroke stroke);
  /// Moves all points that have been added so far by this vector, mm.
  void move_all(Vec3 by);

  /// Returns the vertices in order. The `stroke` of the first vertex has no meaning.
  const std::vector<PlotPoint>& points() const { return points_; }
  bool has_pending() const { return pending_; }
  PlotPoint pending() const { return last_; }

  /// Returns the tolerance of the polyline, mm. A point was removed if its distance from the previous point was less. If the tolerance is
  /// 0, the path is complete.
  double tolerance() const { return tolerance_; }
  std::uint64_t seen() const { return seen_; }
  const Box& box() const { return box_; }
  const Box& cutting_box() const { return cutting_box_; }

 private:
  void keep(PlotPoint point);
  void thin();

  std::size_t most_;
  std::vector<PlotPoint> points_;
  PlotPoint last_{};  // the last added point; if pending_ is true, points_ does not contain it yet
  bool pending_ = false;
  double tolerance_ = 0;
  std::uint64_t seen_ = 0;
  Box box_, cutting_box_;
};

}  // namespace kadr
