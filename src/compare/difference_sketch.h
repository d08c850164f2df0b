#pragma once
// DifferenceSketch: the paths of two programs as paths of a picture: what both do, and what only one does. Used by compare/difference_plot.

#include "out/picture/plot_path.h"

namespace kadr {

/// A piece of a comparison in the picture's coordinates.
struct SketchPiece {
  enum class Layer : std::uint8_t { same, changed, a, b } layer = Layer::same;
  Vec3 from, to;
  Stroke stroke = Stroke::feed;
  ProgramLine line;
  bool act = false;  // a position only, no path
  friend bool operator==(const SketchPiece&, const SketchPiece&) = default;
};

/// Builds a path from pieces. Pieces of a curve that are finer than the picture are joined again.
class SketchPen {
 public:
  SketchPen(PlotPath& path, double chord) : path_(path), chord_(chord) {}
  void take(const SketchPiece& piece);
  void finish();

 private:
  PlotPath& path_;
  double chord_;  // mm by which the path may become less exact
  Vec3 corner_;   // the end of the path
  SketchPiece held_{};
  bool holds_ = false, begun_ = false;
  double lost_ = 0;
};

/// The paths of a comparison, limited in memory.
class DifferenceSketch {
 public:
  ///   most  points in each of its paths
  DifferenceSketch(std::size_t most, double chord);
  DifferenceSketch(const DifferenceSketch&) = delete;
  DifferenceSketch& operator=(const DifferenceSketch&) = delete;

  void take(const SketchPiece& piece);
  void finish();
  void move_all(Vec3 by);

  /// The common path; its box includes the other paths too.
  const PlotPath& same() const { return same_; }
  const PlotPath& changed() const { return changed_; }
  const PlotPath& a() const { return a_; }
  const PlotPath& b() const { return b_; }
  /// The box of what differs.
  const Box& box() const { return box_; }
  /// Returns the greatest distance, in mm, between the true paths and what is drawn.
  double error() const;

 private:
  double chord_;
  PlotPath same_, changed_, a_, b_;
  SketchPen same_pen_, changed_pen_, a_pen_, b_pen_;
  Box box_;
};

}  // namespace kadr
