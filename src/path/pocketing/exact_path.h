#pragma once
// Recovery of exact paths: restores the exact lines and arcs of an offset contour from its polygon. The corners of an offset polygon lie
// on offsets of the original edges: lines, arcs, and circles around the edges' end points. For each chord the carrier is found, that is
// the line or circle on which the chord lies. The exact path follows the carriers; its corners are their intersections.

#include "path/pocketing/polygon.h"

namespace kadr::area {

/// A carrier: a line or circle on which chords of a polygon may lie.
struct Carrier {
  bool line = true;
  Vec2 point;  // a point of the line, or the centre of the circle
  Vec2 way;    // direction of a line, a unit vector
  double radius = 0;
  Bounds box;
};

class Carriers {
 public:
  /// Adds the offsets of `source` to both sides by `by` mm, and circles with the radius `by` around the end points; by = 0: adds the
  /// edges themselves.
  void add(const Edges& source, double by);

  /// Returns the exact edges for the polygon `corners`. A chord without a carrier stays a line.
  ///   law  no point of the result, except its corners, is farther from the polygon than 3·tol::area_chord
  Edges recovered(const Polygon& corners, bool closed) const;

 private:
  struct Run;
  void add(const Carrier& carrier) { all_.push_back(carrier); }
  void index() const;
  std::vector<std::uint32_t> on(Vec2 a, Vec2 b) const;
  std::vector<Run> runs(const Polygon& corners, bool closed) const;

  std::vector<Carrier> all_;
  // grid of cells, each with the indices of the carriers near it; created when first needed
  mutable std::vector<std::vector<std::uint32_t>> cells_;
  mutable Bounds box_;
};

}  // namespace kadr::area
