#pragma once
// Geometry of one edge: a line or an arc of at most half a circle.

#include <limits>

#include "config/contour.h"

namespace kadr::area {

struct Circle {
  Vec2 centre;
  double radius = 0;
};

inline bool is_line(const Edge& e) { return e.bulge == 0; }
Circle circle_of(const Edge& arc);
double length_of(const Edge& e);
double length_of(const Edges& path);
Edge reversed(const Edge& e);
Edges reversed(const Edges& path);

/// Returns the point at `part` of the length, 0..1.
Vec2 at(const Edge& e, double part);
/// Returns the direction of travel at that part, a unit vector.
Vec2 direction(const Edge& e, double part);
/// Returns the piece of the edge between two parts.
Edge stretch(const Edge& e, double from, double to);
/// Returns the part of the edge's point nearest to `p`.
double nearest_part(const Edge& e, Vec2 p);
double distance(const Edge& e, Vec2 p);

/// Returns the least distance between two edges (path/curve/plane_distance); 0 where they cross.
double distance(const Edge& a, const Edge& b);

/// Returns where two edges meet, ends included; overlapping edges give their ends.
std::vector<Vec2> meetings(const Edge& a, const Edge& b);

struct Bounds {
  Vec2 least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 most{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  void take(Vec2 p);
  void take(const Edge& e);
  /// True if the boxes are at most `reach` apart.
  bool near(const Bounds& other, double reach) const;
};
Bounds bounds_of(const Edges& path);

/// Returns the edge rotated about the origin.
Edge rotated(const Edge& e, double deg);

/// Returns a circular arc from `from`, starting in the direction `way`, to `to`; a line if that is straight. An arc longer than half a
/// circle becomes two edges.
Edges tangent_arc(Vec2 from, Vec2 way, Vec2 to);

}  // namespace kadr::area
