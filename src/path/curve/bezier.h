#pragma once
// Bezier: a cubic curve between two points of the axes' space with given directions at its ends. Each inner control point is a third of the
// chord length away from the end of the curve next to it, along the given direction (INFERRED: NCT 4.7 leaves the construction of the curve
// open).

#include "base/vec.h"

namespace kadr {

class Bezier {
 public:
  /// `start_way`, `end_way`: directions of the curve at its start and end, unit vectors.
  Bezier(const Axes& from, const Axes& to, const Axes& start_way, const Axes& end_way);

  /// Returns the point at the parameter `part`, 0 … 1.
  ///   law  at(0) and at(1) are exactly the given end points
  Axes at(double part) const;

  /// Returns the greatest distance between the curve and its chord.
  double off_chord() const;

  /// Returns the number of equal pieces whose chords stay within `chord` mm of the curve.
  int pieces(double chord) const;

 private:
  Axes from_, to_;
  Axes start_pull_, end_pull_;  // the inner control points are from + start_pull and to - end_pull
};

/// Returns the direction, a unit vector, that a curve through the point between two straight pieces has at this point. It is the mean of
/// the pieces' directions, in which the shorter piece has more weight (chord-length weighted, INFERRED, NCT 4.7).
///   pre  the path does not reverse there
Axes way_between(const Axes& before, double before_length, const Axes& behind, double after_length);

}  // namespace kadr
