#pragma once
// Distance of two pieces of path in a plane: lines and arcs.

#include "action/flat_path.h"
#include "path/contour/contour_offset.h"

namespace kadr {

/// A line or an arc, ready for measuring.
struct PlanePiece {
  Vec2 from, to;
  Vec2 center;
  Box2 box;
  double turns = 0;   // swept angle / 360, counter-clockwise positive
  double radius = 0;  // of an arc: the mean of those at its ends
  double slack = 0;   // mm, by which the radius changes along it
  bool is_arc = false;
  static PlanePiece of(const ContourElement& element) {
    return element.is_arc ? arc(element.from, element.to, element.center, element.turns) : line(element.from, element.to);
  }
  static PlanePiece line(Vec2 from, Vec2 to);
  static PlanePiece arc(Vec2 from, Vec2 to, Vec2 center, double turns);
};

/// Least distance of two pieces, mm; of an arc whose radius changes within its slack.
///   law  the same for both orders; not changed by turning, mirroring, reversing
double distance(const PlanePiece& a, const PlanePiece& b);

}  // namespace kadr
