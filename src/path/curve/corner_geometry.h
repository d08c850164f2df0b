#pragma once
// Computes the corner between two contour elements: its position, and the chamfer or rounding at it. NCT 17.1, 17.3. Coordinates are in one
// plane, mm. The travel along an element is in mm for a line, in revolutions (swept angle / 360) for an arc.

#include <optional>

#include "path/compensation/contour_offset.h"

namespace kadr {

/// The line or circle that an element lies on (NCT 17.3.9).
struct Support {
  bool is_circle = false;
  Vec2 point;      // for a line: any point of the line; for a circle: the start of the element
  Vec2 direction;  // for a line: unit vector in the direction of travel
  Vec2 center;     // centre and radius, for a circle
  double radius = 0;
};

/// Selects one of two intersections as the corner.
struct CornerChoice {
  bool farther = false;   // true: the second intersection (word Q above 0)
  bool mirrored = false;  // the plane is mirrored: clockwise becomes counter-clockwise
};

/// Returns the point where two consecutive elements meet (NCT 17.3.1 to 17.3.4). Of two intersections `choice` selects the first or the
/// second. The first is, for a line and a circle, the one that comes first along the line; for two circles, the one that comes first
/// clockwise on the first circle, from the start of its element (INFERRED).
///   returns  nullopt if the elements are parallel, concentric or do not meet
///   law      the corner lies on both elements within tol::same_point
std::optional<Vec2> calculated_corner(const Support& first, const Support& second, CornerChoice choice);

/// A chamfer (a line) or a rounding (an arc) between two elements, and the travel that it removes from each element.
struct CornerElement {
  Vec2 from, to;
  Vec2 center;
  double turns = 0;  // swept angle / 360 of an arc, counter-clockwise positive; 0: a line
  double first_way = 0, second_way = 0;
};

/// Returns the chamfer that removes the length `leg` from each element; on an arc `leg` is a chord length (NCT 17.1).
///   first, second  `first.to` == `second.from`
///   returns        nullopt if `leg` is longer than an arc's diameter
std::optional<CornerElement> chamfer(const ContourElement& first, const ContourElement& second, double leg);

/// The travel on the two elements that a rounding may remove.
struct CornerRoom {
  double first = 0, second = 0;
};

/// Returns the arc with the given radius that is tangent to both elements, on the inner side of the corner. If several arcs fit, returns
/// the one nearest to the corner (NCT 17.1).
///   returns  nullopt if no such arc fits
///   law      the arc's centre is at the distance `radius` from both elements, on their normals at the points of contact
std::optional<CornerElement> rounding(const ContourElement& first, const ContourElement& second, double radius, CornerRoom room);

/// Returns true if the elements meet tangentially, so that no rounding is inserted (NCT 17.1, INFERRED).
bool meet_smoothly(const ContourElement& first, const ContourElement& second);

/// whole_way() returns the whole travel along an element; slack() returns tol::same_point converted to a travel along the element.
double whole_way(const ContourElement& element);
double slack(const ContourElement& element);

/// Returns the rotation from one direction to the other, in revolutions, [0, 1): counter-clockwise if `sense` is 1, else clockwise.
double swept_turns(Vec2 from, Vec2 to, double sense);

}  // namespace kadr
