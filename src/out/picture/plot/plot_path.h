#pragma once
// PlotPath: a path as a polyline with a limited number of points. When the limit is reached, points are removed with a growing tolerance.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "out/picture/canvas.h"
#include "out/text/extents.h"

namespace kadr {

/// Types of stroke. plunge: a feed motion straight down; contour: the programmed contour; jump: nothing is drawn, the path continues at
/// another position.
enum class Stroke : std::uint8_t { rapid, feed, plunge, arc, contour, probe, jump };
inline bool cuts(Stroke stroke) { return stroke != Stroke::rapid && stroke != Stroke::probe && stroke != Stroke::jump; }

/// A vertex, and the type of the stroke that ends there.
struct PlotPoint {
  Vec3 at;
  Stroke stroke;
  float shade = 0;  // value that selects the colour (speed or limit): see out/picture/plot/plot_shades
  ProgramLine line{};
};

class PlotPath {
 public:
  /// Keeps at most `most` points.
  explicit PlotPath(std::size_t most = 100'000) : most_(most) {}

  void start(Vec3 at);
  void go(Vec3 to, Stroke stroke, float shade = 0, ProgramLine line = {});
  /// Extends the path's box by this box: a curve may reach beyond its chords.
  void reach(const Box& box, Stroke stroke);
  /// Moves all points added so far by this vector.
  void move_all(Vec3 by);

  /// The vertices in order; the `stroke` of the first vertex has no meaning.
  const std::vector<PlotPoint>& points() const { return points_; }
  bool has_pending() const { return pending_; }
  PlotPoint pending() const { return last_; }

  /// Tolerance of the thinning, mm: a point closer than this to its predecessor was removed. 0: the path is complete.
  double tolerance() const { return tolerance_; }
  std::uint64_t seen() const { return seen_; }
  const Box& box() const { return box_; }
  const Box& cutting_box() const { return cutting_box_; }

 private:
  void keep(PlotPoint point);
  void thin();

  std::size_t most_;
  std::vector<PlotPoint> points_;
  PlotPoint last_{};  // last point added; while pending_, it is not in points_ yet
  bool pending_ = false;
  double tolerance_ = 0;
  std::uint64_t seen_ = 0;
  Box box_, cutting_box_;
};

}  // namespace kadr
