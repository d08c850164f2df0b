// DifferenceSketch: draws the paths of two programs as paths of a picture. Used by compare/difference_plot; tested by
// tests/compare/difference_sketch_test.cpp.

#include "compare/difference_sketch.h"

#include <algorithm>

#include "base/matrix.h"

namespace kadr {
namespace {

double distance_to_line(Vec3 p, Vec3 from, Vec3 to) {
  const Vec3 delta = to - from;
  const double square = dot(delta, delta);
  const double part = square > 0 ? std::clamp(dot(p - from, delta) / square, 0.0, 1.0) : 0;
  return length(p - (from + part * delta));
}

}  // namespace

void SketchPen::take(const SketchPiece& piece) {
  const bool goes_on = holds_ && piece.from == held_.to && piece.stroke == held_.stroke && piece.line == held_.line;
  if (goes_on) {
    const double loses = distance_to_line(held_.to, corner_, piece.to);
    if (lost_ + loses <= chord_) {
      lost_ += loses;
      held_ = piece;
      return;
    }
  }
  finish();
  if (!begun_) path_.start(piece.from);
  else if (!(piece.from == corner_)) path_.go(piece.from, Stroke::jump);
  begun_ = holds_ = true;
  corner_ = piece.from;
  held_ = piece;
}

void SketchPen::finish() {
  if (!holds_) return;
  path_.go(held_.to, held_.stroke, 0, held_.line);
  corner_ = held_.to;
  holds_ = false;
  lost_ = 0;
}

DifferenceSketch::DifferenceSketch(std::size_t most, double chord)
    : chord_(chord),
      same_(most),
      changed_(most),
      a_(most),
      b_(most),
      same_pen_(same_, chord),
      changed_pen_(changed_, chord),
      a_pen_(a_, chord),
      b_pen_(b_, chord) {}

/// Adds a segment. A segment that differs must be visible, so it is drawn even if it is a rapid.
void DifferenceSketch::take(const SketchPiece& piece) {
  using Layer = SketchPiece::Layer;
  if (piece.layer != Layer::same) {
    Box reached;
    reached.take(piece.from), reached.take(piece.to);
    box_.take(reached);
    same_.reach(reached, Stroke::feed);
  }
  if (piece.act) return;
  switch (piece.layer) {
    case Layer::same: return same_pen_.take(piece);
    case Layer::changed: return changed_pen_.take(piece);
    case Layer::a: return a_pen_.take(piece);
    case Layer::b: return b_pen_.take(piece);
  }
}

void DifferenceSketch::finish() {
  for (SketchPen* const pen : {&same_pen_, &changed_pen_, &a_pen_, &b_pen_}) pen->finish();
}

void DifferenceSketch::move_all(Vec3 by) {
  for (PlotPath* const path : {&same_, &changed_, &a_, &b_}) path->move_all(by);
  if (!box_.empty) box_.least = box_.least + by, box_.most = box_.most + by;
}

double DifferenceSketch::error() const {
  return std::max({chord_, same_.tolerance(), changed_.tolerance(), a_.tolerance(), b_.tolerance()});
}

}  // namespace kadr
