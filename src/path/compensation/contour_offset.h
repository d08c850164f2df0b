#pragma once
// This file has the geometry of a contour offset by the tool radius, in one plane: elements, the vectors at a junction of two elements, and
// compensated arcs (NCT 15.5.0–15.5.4). A vector leads from a programmed point to the corresponding position of the tool's centre. `side`
// is +1 if the tool is left of the path, and −1 if the tool is right of the path.

#include <array>
#include <cstdint>
#include <optional>

#include "action/action.h"
#include "base/vec.h"

namespace kadr {

/// Returns the vector rotated by 90° counter-clockwise.
inline Vec2 left_of(Vec2 v) { return {-v.y, v.x}; }

/// A line or an arc of the programmed contour.
struct ContourElement {
  Vec2 from, to;
  // Unit tangents at both ends. If the radius of an arc changes, these are the tangents of the circles around the arc's centre through the
  // two ends (NCT 15.5.2).
  Vec2 start, end;
  Vec2 center;       // centre of an arc
  double turns = 0;  // swept angle of an arc / 360, positive counter-clockwise
  double start_radius = 0, end_radius = 0;
  bool is_arc = false;

  /// Creates a line. `from` and `to` must differ, because the line needs a direction.
  static ContourElement line(Vec2 from, Vec2 to);
  static ContourElement arc(Vec2 from, Vec2 to, Vec2 center, double turns);

  double sense() const { return turns < 0 ? -1 : 1; }  // Sense of rotation of an arc: +1 for counter-clockwise, −1 for clockwise.
};

/// Returns the unit vector from a point of the path towards the tool's centre. The vector is perpendicular to the path.
inline Vec2 side_normal(Vec2 tangent, double side) { return side * left_of(tangent); }

/// The line or circle along which the tool's centre follows an element. Positions are relative to one end of the element.
struct OffsetElement {
  Vec2 normal;   // unit normal of a line; the distance of the offset line in this direction is `distance`
  Vec2 tangent;  // unit direction of a line
  Vec2 center;   // centre of a circle
  double distance = 0;
  double radius = 0;  // Radius of a circle, mm. It is negative if the tool radius is greater than the radius of a concave arc.
  bool is_arc = false;
};
OffsetElement offset_at_end(const ContourElement& element, double radius, double side);
OffsetElement offset_at_start(const ContourElement& element, double radius, double side);

/// The points, at most two, at which two lines or circles meet, as vectors from a given point.
struct Meetings {
  std::array<Vec2, 2> at{};
  std::uint8_t count = 0;
  void add(Vec2 v) { at[count++] = v; }
};

/// Returns all intersections of the offsets of two elements, as vectors from `point`. The elements themselves meet at `point`.
///   returns  for a line and a circle, the first intersection is the one that comes first along the line; for two circles, it is the one to
///            the left of the direction from the first centre to the second centre. The result is empty if the offsets do not meet or one
///            element is an arc that is too small for the tool
Meetings intersections(const OffsetElement& first, const OffsetElement& second, Vec2 point);

/// Returns the intersection of the offsets of two elements that is nearest to `point`, as a vector from `point`. The elements themselves
/// meet at `point`.
///   returns  nullopt if the offsets do not meet or one element is an arc that is too small for the tool
///   law      the intersection lies on both offsets within tol::same_point
std::optional<Vec2> intersection(const OffsetElement& first, const OffsetElement& second, Vec2 point);

/// The type of a corner as seen from the tool's side (NCT 15.5.0). It depends on the angle alpha: an inside corner is above 180°, an obtuse
/// corner 90° to 180°, and an acute corner below 90°.
enum class Corner : std::uint8_t { inside, obtuse, acute };
Corner corner_of(Vec2 end_tangent, Vec2 start_tangent, double side);

/// The vectors at a junction, in their order. The tool's centre moves straight from the end of one vector to the end of the next vector.
struct JunctionVectors {
  std::array<Vec2, 8> at{};  // Up to four vectors at a corner, or more if the interference check joins two corners (NCT 15.5.7).
  std::uint8_t count = 0;
  // True if the tool's centre moves from the first vector to the second vector along an arc about the programmed point.
  bool round = false;
  void add(Vec2 v) { at[count++] = v; }
  Vec2 first() const { return at[0]; }
  Vec2 last() const { return at[count - 1U]; }
};
inline JunctionVectors single(Vec2 vector) {
  JunctionVectors v;
  v.add(vector);
  return v;
}

/// Removes each vector that differs from the previous vector by less than `least` mm in both axes (NCT N1405 DELTV, 15.5.2). INFERRED: the
/// previous vector remains.
JunctionVectors without_short_steps(const JunctionVectors& vectors, double least);

/// Returns the vectors at a junction in offset mode, in which the tool is on the same side of both elements (NCT 15.5.2).
///   returns  nullopt for an inside corner at which the offsets do not meet (alarm 2047)
std::optional<JunctionVectors> junction(const ContourElement& first, const ContourElement& second, double radius, double side);

/// Returns the vectors at the end of the line that switches compensation on (NCT 15.5.1, type B; the rule is INFERRED).
JunctionVectors start_up(const ContourElement& first, const ContourElement& second, double radius, double side);

/// Returns the vectors at the end of the last compensated block. The line after this block switches compensation off (NCT 15.5.3, type B).
JunctionVectors cancel(const ContourElement& first, const ContourElement& second, double radius, double side);

/// Returns the vectors at a junction for two types of controls (2С42 6.6.7, RS274/NGC). At an outside corner such a control joins the
/// offset path by an arc, or it extends the offset lines until they meet. An offset arc is extended by its tangent line.
///   returns  nullopt for an inside corner at which the offsets do not meet, and for an outside corner at which the extended lines meet too
///            far away
///   law      no point of the joint is nearer to the programmed point than the tool radius
std::optional<JunctionVectors> joined(const ContourElement& first, const ContourElement& second, double radius, double side,
                                      CornerJoin join);

/// Returns the direction of the first move into compensation (RS274/NGC). The tool's centre moves along a line, and the edge of the tool
/// moves along a parallel line that leads to the programmed end point. The move ends next to this end point.
///   travel   vector from the tool's position to the programmed end point, mm
///   returns  a unit vector; nullopt if the distance of the end point is at most the tool radius
std::optional<Vec2> entry_direction(Vec2 travel, double radius, double side);

/// Returns the vectors at the first or last point of a contour that the tool approaches from behind it, or leaves to a point behind it
/// (Sinumerik KONT, spec/sinumerik 13.2). With CornerJoin::arc the line touches the circle around the contour's point (INFERRED).
///   first, second  the elements before and after the point; the approach or the departure is a line
///   approaches     true: `first` is the approach; false: `second` is the departure
///   returns        nullopt if the line comes from the front, or leads there; the tool then moves to the normal of the contour
std::optional<JunctionVectors> around_end(const ContourElement& first, const ContourElement& second, double radius, double side,
                                          CornerJoin join, bool approaches);

/// Returns true if the tool fits into the element. The path of the tool between the two vectors must go forward, and a concave arc must
/// have at least the tool radius.
bool fits(const ContourElement& element, Vec2 start_vector, Vec2 end_vector, double radius, double side);

/// Returns true if the path from one vector to the other vector lies on the offset of the element and goes forward along this offset.
bool is_on_offset(const ContourElement& element, Vec2 start_vector, Vec2 end_vector, double radius, double side);

/// Returns true if the direction changes by at most 180° in total over the two elements. In this case the elements cannot meet again after
/// their junction.
bool gentle(const ContourElement& first, const ContourElement& second);

/// Returns the swept angle / 360 of the compensated path of an arc, positive counter-clockwise. The angle may exceed the swept angle of the
/// programmed arc. It changes its sign if the tool does not fit (NCT 15.5.0, 15.5.7).
double compensated_turns(const ContourElement& arc, Vec2 start_vector, Vec2 end_vector);

}  // namespace kadr
