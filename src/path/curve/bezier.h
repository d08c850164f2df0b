#pragma once
// Bezier: a curve of the third degree between two points of the axes' space with given directions there. INFERRED (NCT 4.7 leaves
// its construction open): the inner control points lie a third of the chord along the directions.

#include "base/vec.h"

namespace kadr {

class Bezier {
 public:
  /// `start_way`, `end_way`: unit vectors.
  Bezier(const Axes& from, const Axes& to, const Axes& start_way, const Axes& end_way);

  /// At the part 0..1.
  ///   law  at(0) and at(1) are the ends, bit by bit
  Axes at(double part) const;

  /// The greatest distance between the curve and its chord.
  double off_chord() const;

  /// Number of equal pieces whose chords stay within `chord` mm of the curve.
  int pieces(double chord) const;

 private:
  Axes from_, to_;
  Axes start_pull_, end_pull_;  // control points: from + start_pull, to - end_pull
};

/// Unit vector at the point between two straight ways: the nearer neighbour's counts more (chord-length weighted, INFERRED, NCT 4.7).
///   pre  they do not turn back
Axes way_between(const Axes& before, double before_length, const Axes& behind, double behind_length);

}  // namespace kadr
