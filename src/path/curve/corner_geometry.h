#pragma once
// This file computes the corner between two contour elements: its position, and the chamfer or rounding at the corner (NCT 17.1, 17.3).
// Coordinates are in one plane, in mm. The travel along a line is in mm; the travel along an arc is in revolutions (swept angle / 360).

#include <optional>

#include "path/compensation/contour_offset.h"

namespace kadr {

/// The line or the circle on which an element lies (NCT 17.3.9).
struct Support {
  bool is_circle = false;
  Vec2 point;      // a point on the line or circle: any point of a line, but the start of the element on a circle
  Vec2 direction;  // unit vector in the direction of travel of a line
  Vec2 center;     // centre of the circle; `radius` is its radius, mm
  double radius = 0;
};

/// The choice of one of two intersections as the corner.
struct CornerChoice {
  bool farther = false;   // true: the second of the two intersections is the corner (word Q above 0)
  bool mirrored = false;  // True: the plane is mirrored, so clockwise becomes counter-clockwise.
};

/// Returns the point where two consecutive elements meet (NCT 17.3.1 to 17.3.4). If there are two intersections, `choice` selects one of
/// them. For a line and a circle, the first intersection is the intersection that comes first along the line. For two circles it is the
/// intersection that comes first clockwise on the first circle, from the start of the circle's element (INFERRED).
///   returns  nullopt if the elements are parallel, concentric or do not meet
///   law      the corner lies on both elements within tol::same_point
std::optional<Vec2> calculated_corner(const Support& first, const Support& second, CornerChoice choice);

/// A chamfer (a line) or a rounding (an arc) between two elements. `first_travel` and `second_travel` are the travel that it removes from
/// each element.
struct CornerElement {
  Vec2 from, to;
  Vec2 center;
  double turns = 0;  // swept angle / 360 of an arc, positive counter-clockwise; 0 for a line
  double first_travel = 0, second_travel = 0;
};

/// Returns the chamfer that removes the length `leg` from each element; on an arc `leg` is a chord length (NCT 17.1).
///   first, second  `first.to` == `second.from`
///   returns        nullopt if `leg` is longer than an arc's diameter
std::optional<CornerElement> chamfer(const ContourElement& first, const ContourElement& second, double leg);

/// The travel on each of the two elements that a rounding may remove.
struct CornerRoom {
  double first = 0, second = 0;
};

/// Returns the arc with the given radius that is tangent to both elements, on the inner side of the corner. If several arcs fit, the
/// function returns the arc nearest to the corner (NCT 17.1).
///   returns  nullopt if no such arc fits
///   law      the arc's centre is at the distance `radius` from both elements, on their normals at the points of contact
std::optional<CornerElement> rounding(const ContourElement& first, const ContourElement& second, double radius, CornerRoom room);

/// Returns true if the elements meet tangentially, so that no rounding is inserted (NCT 17.1, INFERRED).
bool meet_smoothly(const ContourElement& first, const ContourElement& second);

/// whole_travel() returns the whole travel along an element. slack() returns the tolerance tol::same_point converted to a travel along the
/// element.
double whole_travel(const ContourElement& element);
double slack(const ContourElement& element);

/// Returns the rotation from one direction to another direction, in revolutions from 0 to below 1. The rotation is counter-clockwise if
/// `sense` is 1, otherwise clockwise.
double swept_turns(Vec2 from, Vec2 to, double sense);

}  // namespace kadr
