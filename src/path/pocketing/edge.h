#pragma once
// This file has the geometry of one edge of a contour in a plane: a line, or an arc of at most half a circle.

#include <limits>

#include "config/drawing/drawing.h"

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

/// Returns the point at the fraction `part`, 0 to 1, of the edge's length.
Vec2 at(const Edge& e, double part);
/// Returns the direction of travel, a unit vector, at the fraction `part` of the edge's length.
Vec2 direction(const Edge& e, double part);
/// Returns the section of the edge between two fractions of its length.
Edge section(const Edge& e, double from, double to);
/// Returns the position at which the edge is nearest to `p`, as a fraction (0 to 1) of the edge's length.
double nearest_part(const Edge& e, Vec2 p);
double distance(const Edge& e, Vec2 p);

/// Returns the least distance, mm, between two edges (path/curve/plane_distance); 0 if the edges cross.
double distance(const Edge& a, const Edge& b);

/// Returns the points that two edges have in common; end points are included. If the edges overlap, the points are the end points of the
/// overlap.
std::vector<Vec2> meetings(const Edge& a, const Edge& b);

struct Bounds {
  Vec2 least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 most{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  void take(Vec2 p);
  void take(const Edge& e);
  /// True if the distance between the two bounding boxes is at most `reach`, mm.
  bool near(const Bounds& other, double reach) const;
};
Bounds bounds_of(const Edges& path);

/// Returns the edge rotated about the origin by `deg` degrees, counter-clockwise.
Edge rotated(const Edge& e, double deg);

/// Returns the circular arc from `from` to `to` that starts in the direction `tangent`. If `to` lies straight ahead, the result is a line.
/// An arc that is longer than half a circle becomes two edges.
Edges tangent_arc(Vec2 from, Vec2 tangent, Vec2 to);

}  // namespace kadr::area
