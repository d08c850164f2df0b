#pragma once
// RingSweep: what a body of an insert sweeps along a straight way, in the half plane of a part that spins: a ring about the axis.
//
// Body and way are convex, and so is the hull that is swept: its outline is the body's, with the way as two more edges where it turns from
// ahead to behind. A line along Z sees one radius, a level line one height: both cut the outline in one interval, in closed form.
// x is the signed radius: where the insert reaches across the axis, what is left of it counts on both sides.
//
//   law  a place is within a slice if the insert is there at some part of the way, to 1e-9 mm   (tests/stock/turn_test)

#include <vector>

#include "stock/tool/insert_body.h"

namespace kadr {

/// None if `to` is not behind `from`.
struct RingRange {
  double from = 1e300, to = -1e300;

  bool none() const { return !(from < to); }
  void include(double a) { from = a < from ? a : from, to = a > to ? a : to; }
};

/// Of radii, mm, of a range of signed ones.
RingRange folded(const RingRange& x);

class RingSweep {
 public:
  struct Edge {
    InsertPoint from, to, outward;
    double per_x, per_z;  // 1 / length along x, z; 0 where there is none
  };
  /// `first`, `last`: the outward normals between which the outline follows it.
  struct Arc {
    InsertPoint centre;
    double radius;
    InsertPoint first, last;
  };

  /// Of the programmed point.
  RingSweep(const InsertBody& body, const InsertPoint& from, const InsertPoint& to);

  /// Heights that are swept at a signed radius.
  RingRange at_x(double x) const;
  /// Signed radii at a height.
  RingRange at_z(double z) const;
  /// Signed radii between two heights.
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
