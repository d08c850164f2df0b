#pragma once
// Bezier is a cubic curve between two points of the axes' space with given directions at its ends. INFERRED (NCT 4.7 does not state how the
// curve is constructed): the distance of each inner control point from the nearer end of the curve is a third of the chord length, along
// the given direction.

#include "base/vec.h"

namespace kadr {

class Bezier {
 public:
  /// `start_direction` and `end_direction` are the directions of the curve at its start and its end, as unit vectors.
  Bezier(const Axes& from, const Axes& to, const Axes& start_direction, const Axes& end_direction);

  /// Returns the point at the parameter `part`, 0 to 1.
  ///   law  at(0) and at(1) are exactly the given end points
  Axes at(double part) const;

  /// Returns the greatest distance, mm, between the curve and its chord.
  double off_chord() const;

  /// Returns into how many parts of equal parameter range the curve must be divided, so that the chords stay within `chord` mm of the
  /// curve.
  int pieces(double chord) const;

 private:
  Axes from_, to_;
  Axes start_pull_, end_pull_;  // The inner control points are from_ + start_pull_ and to_ − end_pull_.
};

/// Returns the direction, a unit vector, of a curve at the point between two straight pieces. INFERRED (NCT 4.7): the direction is the mean
/// of the pieces' directions, in which the shorter piece has more weight.
///   pre  the path does not reverse at this point
Axes direction_between(const Axes& before, double before_length, const Axes& after, double after_length);

}  // namespace kadr
