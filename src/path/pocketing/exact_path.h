#pragma once
// This file restores the exact lines and arcs of an offset contour from its polygon. The corners of an offset polygon lie on the offsets of
// the original edges (lines and arcs) and on circles around the end points of these edges. The carrier of a chord is the line or circle on
// which the chord lies. The exact path follows the carriers; its corners are the intersections of the carriers.

#include "path/pocketing/polygon.h"

namespace kadr::area {

/// A carrier is a line or a circle on which chords of a polygon may lie.
struct Carrier {
  bool line = true;
  Vec2 point;      // any point of the carrier line, or the centre of the carrier circle
  Vec2 direction;  // direction of the carrier line as a unit vector
  double radius = 0;
  Bounds box;
};

class Carriers {
 public:
  /// Adds the offsets of `source` by `by` mm to both sides, and circles with the radius `by` mm around the end points. If `by` is 0, the
  /// function adds the edges themselves.
  void add(const Edges& source, double by);

  /// Returns the exact edges for the polygon `corners`. A chord without a carrier stays a line.
  ///   law  except at the corners of the result, its distance from the polygon is at most 3·tol::area_chord
  Edges recovered(const Polygon& corners, bool closed) const;

 private:
  struct Run;
  void add(const Carrier& carrier) { all_.push_back(carrier); }
  void index() const;
  std::vector<std::uint32_t> on(Vec2 a, Vec2 b) const;
  std::vector<Run> runs(const Polygon& corners, bool closed) const;

  std::vector<Carrier> all_;
  // A grid of cells. Each cell has the indices of the carriers near this cell. The grid is created when it is first needed.
  mutable std::vector<std::vector<std::uint32_t>> cells_;
  mutable Bounds box_;
};

}  // namespace kadr::area
