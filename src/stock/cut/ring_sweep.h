#pragma once
// RingSweep: the ring that a turning tool sweeps about the axis of a spinning part, when the convex outline of its insert moves along a
// straight path. The ring is described in the half plane through the axis.
//
// The outline and the path are convex, so the swept area is convex too. The outline of the swept area is that of the insert, with the path
// inserted as two more straight edges where the insert's outline changes from its front to its back. Lattice lines along Z have a constant
// radius, and lines along X and Y have a constant height. Each line intersects the swept area in one interval, which has an exact formula.
// x is the signed radius: an insert that reaches across the axis cuts on both sides.
//
//   law  a point is in an interval if the insert contains the point at some position on the path, to within 1e-9 mm (tests/stock/turn_test)

#include <vector>

#include "stock/tool/insert_body.h"

namespace kadr {

/// A range of radii or heights, mm; empty if `to` is not greater than `from`.
struct RingRange {
  double from = 1e300, to = -1e300;

  bool none() const { return !(from < to); }
  void include(double a) { from = a < from ? a : from, to = a > to ? a : to; }
};

/// Converts a range of signed radii into a range of radii (absolute values), mm.
RingRange folded(const RingRange& x);

class RingSweep {
 public:
  struct Edge {
    InsertPoint from, to, outward;
    double per_x, per_z;  // inverses of the edge's extents along x and along z, in 1/mm; 0 for an extent of 0
  };
  /// An arc of the outline. `first` and `last` are the outward unit normals at the two ends of the arc.
  struct Arc {
    InsertPoint centre;
    double radius;
    InsertPoint first, last;
  };

  /// `from`, `to`: start and end of the path of the programmed point, mm.
  RingSweep(const InsertBody& body, const InsertPoint& from, const InsertPoint& to);

  /// Returns the heights that are swept at a signed radius.
  RingRange at_x(double x) const;
  /// Returns the signed radii that are swept at a height.
  RingRange at_z(double z) const;
  /// Returns the signed radii that are swept between two heights.
  RingRange between(double low, double high) const;
  RingRange heights() const;

  const std::vector<Edge>& edges() const { return edges_; }
  const std::vector<Arc>& arcs() const { return arcs_; }

 private:
  void add_edge(const InsertCorner& a, const InsertCorner& b, const InsertPoint& outward);

  std::vector<Edge> edges_;
  std::vector<Arc> arcs_;
};

}  // namespace kadr
