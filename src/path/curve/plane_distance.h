#pragma once
// The distance of two pieces of a path in a plane, lines or arcs.

#include "action/flat_path.h"
#include "path/contour/contour_offset.h"

namespace kadr {

/// A line or an arc, with data precomputed for measuring.
struct PlanePiece {
  Vec2 from, to;
  Vec2 center;
  Box2 box;
  double turns = 0;   // swept angle / 360, counter-clockwise positive
  double radius = 0;  // of an arc: the mean of the radii at its ends
  double slack = 0;   // mm, by which the radius changes along the arc
  bool is_arc = false;
  static PlanePiece of(const ContourElement& element) {
    return element.is_arc ? arc(element.from, element.to, element.center, element.turns) : line(element.from, element.to);
  }
  static PlanePiece line(Vec2 from, Vec2 to);
  static PlanePiece arc(Vec2 from, Vec2 to, Vec2 center, double turns);
};

/// Returns the least distance of two pieces, mm; for an arc whose radius changes, accurate to its slack.
///   law  independent of the order; not changed by rotation, mirroring, reversal
double distance(const PlanePiece& a, const PlanePiece& b);

}  // namespace kadr
