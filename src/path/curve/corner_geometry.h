#pragma once
// The corner between two elements of a contour: its calculated position, and the chamfer or rounding there. NCT 17.1, 17.3. All in one
// plane, mm. A travel ("way") along an element is in mm for a line, in turns (swept angle / 360) for an arc.

#include <optional>

#include "path/contour/contour_offset.h"

namespace kadr {

/// The line or circle that an element lies on (17.3.9).
struct Support {
  bool is_circle = false;
  Vec2 point;      // of a line: one of its points; of a circle: the start of the element
  Vec2 direction;  // of a line: unit vector in the direction of travel
  Vec2 center;     // of a circle
  double radius = 0;
};

/// Which of two intersections is the corner.
struct CornerChoice {
  bool farther = false;   // Q above 0
  bool mirrored = false;  // the plane is mirrored: clockwise becomes counter-clockwise
};

/// Returns the point where two consecutive elements meet (17.3.1 to 17.3.4). Of a line and a circle: the point that the line meets first,
/// or the other one; of two circles: the point that comes first clockwise on the first circle, from the start of its element (INFERRED),
/// or the other.
///   returns  nullopt if they are parallel, concentric or do not meet
///   law      the corner lies on both within tol::same_point
std::optional<Vec2> calculated_corner(const Support& first, const Support& second, CornerChoice choice);

/// A chamfer (a line) or a rounding (an arc) between two elements, and how much it removes from them.
struct CornerElement {
  Vec2 from, to;
  Vec2 center;
  double turns = 0;  // of an arc, counter-clockwise positive; 0: a line
  double first_way = 0, second_way = 0;
};

/// Returns the chamfer with this leg length; on an arc the leg is a chord (17.1).
///   first, second  `first.to` == `second.from`
///   returns        nullopt if the leg is longer than an arc's diameter
std::optional<CornerElement> chamfer(const ContourElement& first, const ContourElement& second, double leg);

/// The available travel on the two elements.
struct CornerRoom {
  double first = 0, second = 0;
};

/// Returns the arc of this radius that is tangent to both elements, on the side to which they turn: of those that fit, the one nearest to
/// the corner (17.1).
///   returns  nullopt if none fits
///   law      its centre is at the distance `radius` from both elements, perpendicular to them at the points of contact
std::optional<CornerElement> rounding(const ContourElement& first, const ContourElement& second, double radius, CornerRoom room);

/// Returns true if the elements meet without a corner: then no rounding is inserted (17.1, INFERRED).
bool meet_smoothly(const ContourElement& first, const ContourElement& second);

/// Return the whole travel along an element, and tol::same_point as a travel along it.
double whole_way(const ContourElement& element);
double slack(const ContourElement& element);

/// Returns the swept turns from one direction to the other, counter-clockwise if `sense` is 1, else clockwise; [0, 1).
double swept_turns(Vec2 from, Vec2 to, double sense);

}  // namespace kadr
