#pragma once
// Geometry of a contour offset by the tool radius, in one plane: elements, the vectors at a junction of two elements, compensated arcs.
// NCT 15.5.0–15.5.4. A vector leads from a programmed point to the corresponding position of the tool's centre. `side`: +1 if the tool is
// left of the path, -1 if it is right.

#include <array>
#include <cstdint>
#include <optional>

#include "action/action.h"
#include "base/vec.h"

namespace kadr {

/// Returns the vector rotated by 90° to the left.
inline Vec2 left_of(Vec2 v) { return {-v.y, v.x}; }

/// A line or an arc of the programmed contour.
struct ContourElement {
  Vec2 from, to;
  // unit tangents at both ends; if the radius of an arc changes, the tangents of the circles around its centre through its ends
  // (NCT 15.5.2)
  Vec2 start, end;
  Vec2 center;       // centre of an arc
  double turns = 0;  // swept angle of an arc / 360, counter-clockwise positive
  double start_radius = 0, end_radius = 0;
  bool is_arc = false;

  /// `from` and `to` must differ.
  static ContourElement line(Vec2 from, Vec2 to);
  static ContourElement arc(Vec2 from, Vec2 to, Vec2 center, double turns);

  double sense() const { return turns < 0 ? -1 : 1; }  // sense of rotation of an arc: +1 counter-clockwise, -1 clockwise
};

/// Returns the unit vector from a point of the path towards the tool's centre, perpendicular to the path.
inline Vec2 side_normal(Vec2 tangent, double side) { return side * left_of(tangent); }

/// The line or circle that the tool's centre follows along an element, relative to one of the element's ends.
struct OffsetElement {
  Vec2 normal;   // unit normal of a line; the offset line is `distance` away in this direction
  Vec2 tangent;  // unit direction of a line
  Vec2 center;   // centre of a circle
  double distance = 0;
  double radius = 0;  // radius of a circle; negative if the tool radius exceeds that of the concave arc
  bool is_arc = false;
};
OffsetElement offset_at_end(const ContourElement& element, double radius, double side);
OffsetElement offset_at_start(const ContourElement& element, double radius, double side);

/// The points where two lines or circles meet, at most two, as vectors from a given point.
struct Meetings {
  std::array<Vec2, 2> at{};
  std::uint8_t count = 0;
  void add(Vec2 v) { at[count++] = v; }
};

/// Returns all intersections of the offsets of two elements, as vectors from `point`. The elements themselves meet at `point`.
///   returns  for a line and a circle: first the intersection that comes first along the line; for two circles: first the intersection to
///            the left of the direction from the first centre to the second. Empty if the offsets do not meet, or one element is an arc
///            too small for the tool
Meetings intersections(const OffsetElement& first, const OffsetElement& second, Vec2 point);

/// Returns the intersection of the offsets of two elements that is nearest to `point`, as a vector from `point`. The elements themselves
/// meet at `point`.
///   returns  nullopt if the offsets do not meet, or one element is an arc too small for the tool
///   law      the intersection lies on both offsets within tol::same_point
std::optional<Vec2> intersection(const OffsetElement& first, const OffsetElement& second, Vec2 point);

/// The type of a corner seen from the tool's side (NCT 15.5.0), by the angle alpha: inside above 180°, obtuse from 90° to 180°, acute below
/// 90°.
enum class Corner : std::uint8_t { inside, obtuse, acute };
Corner corner_of(Vec2 end_tangent, Vec2 start_tangent, double side);

/// The vectors at a junction, in order. The tool's centre moves straight from the end of one vector to the end of the next.
struct JunctionVectors {
  std::array<Vec2, 8> at{};  // the vectors: up to four at a corner; more if the interference check joins two corners (NCT 15.5.7)
  std::uint8_t count = 0;
  bool round = false;  // the tool's centre moves from the first to the second vector along an arc about the programmed point
  void add(Vec2 v) { at[count++] = v; }
  Vec2 first() const { return at[0]; }
  Vec2 last() const { return at[count - 1U]; }
};
inline JunctionVectors single(Vec2 vector) {
  JunctionVectors v;
  v.add(vector);
  return v;
}

/// Removes each vector that differs from the previous vector by less than `least` mm in both axes (NCT N1405 DELTV, 15.5.2; which of the
/// two vectors remains is INFERRED).
JunctionVectors without_short_steps(const JunctionVectors& vectors, double least);

/// Returns the vectors at a junction in offset mode, where the tool is on the same side of both elements (NCT 15.5.2).
///   returns  nullopt for an inside corner whose offsets do not meet (alarm 2047)
std::optional<JunctionVectors> junction(const ContourElement& first, const ContourElement& second, double radius, double side);

/// Returns the vectors at the end of the line that switches compensation on (NCT 15.5.1, type B of the INFERRED rule).
JunctionVectors start_up(const ContourElement& first, const ContourElement& second, double radius, double side);

/// Returns the vectors at the end of the last compensated block, before the line that switches compensation off (NCT 15.5.3, type B).
JunctionVectors cancel(const ContourElement& first, const ContourElement& second, double radius, double side);

/// Returns the vectors at a junction for controls that join the offset path at an outside corner by an arc, or by extending the offset
/// lines until they meet (2С42 6.6.7, RS274/NGC). An offset arc is extended by its tangent line.
///   returns  nullopt for an inside corner whose offsets do not meet, and for an outside corner whose extended lines meet too far away
///   law      no point of the joint is nearer to the programmed point than the radius
std::optional<JunctionVectors> joined(const ContourElement& first, const ContourElement& second, double radius, double side,
                                      CornerJoin join);

/// Returns the direction of the first move into compensation (RS274/NGC): the tool's centre moves along a line such that the tool touches
/// the programmed line all along, and ends next to the programmed end point.
///   way      vector from the tool's position to the programmed end point, mm
///   returns  a unit vector; nullopt if the end point is no further away than the tool radius
std::optional<Vec2> entry_direction(Vec2 way, double radius, double side);

/// Returns true if the tool fits in at the element: the tool's path between the two vectors goes forward, and a concave arc has at least
/// the tool radius.
bool fits(const ContourElement& element, Vec2 start_vector, Vec2 end_vector, double radius, double side);

/// Returns true if the path from one vector to the other lies on the element's offset and goes forward along it.
bool lies_on_offset(const ContourElement& element, Vec2 start_vector, Vec2 end_vector, double radius, double side);

/// Returns true if the direction changes by at most 180° in total over the two elements. Then the elements cannot meet again after their
/// junction.
bool gentle(const ContourElement& first, const ContourElement& second);

/// Returns the swept angle / 360 of an arc's compensated path, counter-clockwise positive. It may exceed the swept angle of the
/// programmed arc, and it changes sign if the tool does not fit (NCT 15.5.0, 15.5.7).
double compensated_turns(const ContourElement& arc, Vec2 start_vector, Vec2 end_vector);

}  // namespace kadr
