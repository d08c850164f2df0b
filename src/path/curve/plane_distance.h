#pragma once
// This file computes the distance between two pieces of a path in a plane. A piece is a line or an arc.

#include "action/flat_path.h"
#include "path/compensation/contour_offset.h"

namespace kadr {

/// A line or an arc in a plane, with precomputed data for the measurement of distances.
struct PlanePiece {
  Vec2 from, to;
  Vec2 center;
  Box2 box;
  double turns = 0;   // swept angle / 360, positive counter-clockwise
  double radius = 0;  // radius of an arc, mm: the mean of the radii at its start and its end
  double slack = 0;   // the change of the radius along the arc, mm
  bool is_arc = false;
  static PlanePiece of(const ContourElement& element) {
    return element.is_arc ? arc(element.from, element.to, element.center, element.turns) : line(element.from, element.to);
  }
  static PlanePiece line(Vec2 from, Vec2 to);
  static PlanePiece arc(Vec2 from, Vec2 to, Vec2 center, double turns);
};

/// Returns the least distance between two pieces, mm. For an arc whose radius changes, the error is at most the arc's slack.
///   law  the result does not depend on the order of the pieces; rotation, mirroring and reversal do not change it
double distance(const PlanePiece& a, const PlanePiece& b);

}  // namespace kadr
