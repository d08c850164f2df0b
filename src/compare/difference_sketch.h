#pragma once
// DifferenceSketch: the ways of two programs as paths of a picture: what both do, what only one does. For compare/difference_plot.

#include "out/picture/plot_path.h"

namespace kadr {

/// A piece of a comparison in the picture's coordinates.
struct SketchPiece {
  enum class Layer : std::uint8_t { same, changed, a, b } layer = Layer::same;
  Vec3 from, to;
  Stroke stroke = Stroke::feed;
  ProgramLine line;
  bool act = false;  // only a place
  friend bool operator==(const SketchPiece&, const SketchPiece&) = default;
};

/// Pieces → a path. Those of a curve that are finer than the picture are joined again.
class SketchPen {
 public:
  SketchPen(PlotPath& path, double chord) : path_(path), chord_(chord) {}
  void take(const SketchPiece& piece);
  void finish();

 private:
  PlotPath& path_;
  double chord_;  // mm that may be lost
  Vec3 corner_;   // where the path stands
  SketchPiece held_{};
  bool holds_ = false, begun_ = false;
  double lost_ = 0;
};

/// Bounded in memory.
class DifferenceSketch {
 public:
  /// `most`: points of each of its paths.
  DifferenceSketch(std::size_t most, double chord);
  DifferenceSketch(const DifferenceSketch&) = delete;
  DifferenceSketch& operator=(const DifferenceSketch&) = delete;

  void take(const SketchPiece& piece);
  void finish();
  void move_all(Vec3 by);

  /// Its box holds all the others too.
  const PlotPath& same() const { return same_; }
  const PlotPath& changed() const { return changed_; }
  const PlotPath& a() const { return a_; }
  const PlotPath& b() const { return b_; }
  /// Where they differ.
  const Box& box() const { return box_; }
  /// mm between the ways and what is drawn.
  double error() const;

 private:
  double chord_;
  PlotPath same_, changed_, a_, b_;
  SketchPen same_pen_, changed_pen_, a_pen_, b_pen_;
  Box box_;
};

}  // namespace kadr
