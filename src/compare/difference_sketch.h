#pragma once
// DifferenceSketch: the paths of two programs, prepared for drawing: the path that both programs follow, and the paths that only one
// program follows. Used by compare/difference_plot.

#include "out/picture/plot/plot_path.h"

namespace kadr {

/// A segment of a comparison in the coordinates of the picture.
struct SketchPiece {
  enum class Layer : std::uint8_t { same, changed, a, b } layer = Layer::same;
  Vec3 from, to;
  Stroke stroke = Stroke::feed;
  ProgramLine line;
  bool act = false;  // true if the segment stands for an act: it has a position but no length
  friend bool operator==(const SketchPiece&, const SketchPiece&) = default;
};

/// Builds a path from segments. Joins segments of a curve that are shorter than the picture can show.
class SketchPen {
 public:
  SketchPen(PlotPath& path, double chord) : path_(path), chord_(chord) {}
  void take(const SketchPiece& piece);
  void finish();

 private:
  PlotPath& path_;
  double chord_;  // greatest deviation of the joined path from the segments, mm
  Vec3 corner_;   // end of the joined path so far
  SketchPiece held_{};
  bool holds_ = false, begun_ = false;
  double lost_ = 0;
};

/// The paths of a comparison, with a limited number of points.
class DifferenceSketch {
 public:
  ///   most  greatest number of points in each path
  DifferenceSketch(std::size_t most, double chord);
  DifferenceSketch(const DifferenceSketch&) = delete;
  DifferenceSketch& operator=(const DifferenceSketch&) = delete;

  void take(const SketchPiece& piece);
  void finish();
  void move_all(Vec3 by);

  /// Returns the path that both programs follow. Its box also includes the paths that differ.
  const PlotPath& same() const { return same_; }
  const PlotPath& changed() const { return changed_; }
  const PlotPath& a() const { return a_; }
  const PlotPath& b() const { return b_; }
  /// Returns the box of the paths that differ.
  const Box& box() const { return box_; }
  /// Returns the greatest distance, mm, between a true path and its drawn path.
  double error() const;

 private:
  double chord_;
  PlotPath same_, changed_, a_, b_;
  SketchPen same_pen_, changed_pen_, a_pen_, b_pen_;
  Box box_;
};

}  // namespace kadr
