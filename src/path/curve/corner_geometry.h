#pragma once
// The corner between two elements of a contour: where it lies if that is to be calculated, the chamfer and the rounding there.
// NCT 17.1, 17.3. All in one plane, mm. A way along an element: mm of a line, turns (swept angle / 360) of an arc.

#include <optional>

#include "path/contour/contour_offset.h"

namespace kadr {

/// The line or circle that an element lies on (17.3.9).
struct Support {
  bool is_circle = false;
  Vec2 point;      // of a line: one of its points; of a circle: where the element begins
  Vec2 direction;  // of a line: unit vector, the way it is run
  Vec2 center;     // of a circle
  double radius = 0;
};

/// Which of two intersections the corner is.
struct CornerChoice {
  bool farther = false;   // Q above 0
  bool mirrored = false;  // the plane is: clockwise is counter-clockwise
};

/// Where two consecutive elements meet (17.3.1 to 17.3.4). Of a line and a circle the point that the line meets first, or the other;
/// of two circles that which comes first clockwise on the first circle, from where its element begins (INFERRED), or the other.
///   returns  nothing: they are parallel, concentric or do not meet
///   law      the corner lies on both within tol::same_point
std::optional<Vec2> calculated_corner(const Support& first, const Support& second, CornerChoice choice);

/// A chamfer (a line) or a rounding (an arc) between two elements, and what it takes off them.
struct CornerElement {
  Vec2 from, to;
  Vec2 center;
  double turns = 0;  // of an arc, counter-clockwise positive; 0: a line
  double first_way = 0, second_way = 0;
};

/// Chamfer of that leg: on an arc the leg is a chord (17.1).
///   first, second  `first.to` == `second.from`
///   returns        nothing: the leg is longer than an arc's diameter
std::optional<CornerElement> chamfer(const ContourElement& first, const ContourElement& second, double leg);

/// How much of the two elements there is.
struct CornerRoom {
  double first = 0, second = 0;
};

/// The arc of that radius tangent to both elements, on the side to which they turn, the nearest to the corner that finds room (17.1).
///   returns  nothing: there is none
///   law      its centre is `radius` from both elements, beside the points where it touches them
std::optional<CornerElement> rounding(const ContourElement& first, const ContourElement& second, double radius, CornerRoom room);

/// The elements meet without a corner: no rounding is inserted there (17.1, INFERRED).
bool meet_smoothly(const ContourElement& first, const ContourElement& second);

/// Length of an element as a way, and tol::same_point as one.
double whole_way(const ContourElement& element);
double slack(const ContourElement& element);

/// Turns from one direction to the other, counter-clockwise with `sense` 1, else clockwise; [0, 1).
double swept_turns(Vec2 from, Vec2 to, double sense);

}  // namespace kadr
