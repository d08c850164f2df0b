#pragma once
// RingSweep: what a body of an insert sweeps along a straight path, in the half plane of a spinning part: a ring about the axis.
//
// Body and path are convex, and so is the swept hull: its outline is the body's, with the path as two more edges where the outline
// changes from front to back. A line along Z has one radius, a level line one height: both cut the outline in one interval, in closed
// form. x is the signed radius: if the insert reaches across the axis, both sides are cut.
//
//   law  a point is in a slice if the insert is there at some share of the path, to 1e-9 mm   (tests/stock/turn_test)

#include <vector>

#include "stock/tool/insert_body.h"

namespace kadr {

/// A range; empty if `to` is not greater than `from`.
struct RingRange {
  double from = 1e300, to = -1e300;

  bool none() const { return !(from < to); }
  void include(double a) { from = a < from ? a : from, to = a > to ? a : to; }
};

/// Converts a range of signed radii into a range of radii, mm.
RingRange folded(const RingRange& x);

class RingSweep {
 public:
  struct Edge {
    InsertPoint from, to, outward;
    double per_x, per_z;  // 1 / length along x, z; 0 if that length is 0
  };
  /// `first`, `last`: the outward normals at the ends of the arc in the outline.
  struct Arc {
    InsertPoint centre;
    double radius;
    InsertPoint first, last;
  };

  /// The path is that of the programmed point.
  RingSweep(const InsertBody& body, const InsertPoint& from, const InsertPoint& to);

  /// Returns the swept heights at a signed radius.
  RingRange at_x(double x) const;
  /// Returns the swept signed radii at a height.
  RingRange at_z(double z) const;
  /// Returns the swept signed radii between two heights.
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
