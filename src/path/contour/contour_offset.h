#pragma once
// The contour in its plane, offset by the tool's radius: elements, the vectors at a junction of two elements, compensated arcs. NCT
// 15.5.0–15.5.4. A vector leads from the programmed point to the tool's centre. Side: +1 the tool is left of the path, -1 right.

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
  Vec2 start, end;   // unit tangents; of an arc whose radius changes, tangents of the circles through its ends (15.5.2)
  Vec2 center;       // of an arc
  double turns = 0;  // of an arc: swept angle / 360, counter-clockwise positive
  double start_radius = 0, end_radius = 0;
  bool is_arc = false;

  /// `from` and `to` must differ.
  static ContourElement line(Vec2 from, Vec2 to);
  static ContourElement arc(Vec2 from, Vec2 to, Vec2 center, double turns);

  double sense() const { return turns < 0 ? -1 : 1; }  // +1 counter-clockwise
};

/// Returns the unit vector from a point of the path towards the tool's centre.
inline Vec2 side_normal(Vec2 tangent, double side) { return side * left_of(tangent); }

/// The line or circle that the tool's centre follows along an element, relative to one of the element's ends.
struct OffsetElement {
  Vec2 normal;   // of a line: the offset is `distance` along it
  Vec2 tangent;  // of a line
  Vec2 center;   // of a circle
  double distance = 0;
  double radius = 0;  // negative: the tool is larger than the concave arc
  bool is_arc = false;
};
OffsetElement offset_at_end(const ContourElement& element, double radius, double side);
OffsetElement offset_at_start(const ContourElement& element, double radius, double side);

/// Where two lines or circles meet: vectors from a given point.
struct Meetings {
  std::array<Vec2, 2> at{};
  std::uint8_t count = 0;
  void add(Vec2 v) { at[count++] = v; }
};

/// Returns all intersections of the offsets of two elements, as vectors from `point`, where the elements meet.
///   returns  of a line and a circle: first the one met first along the line, then the other; of two circles: first the one on the left
///            of the direction from the first centre to the second, then the other. Empty if they do not meet, or one of them is an arc
///            too small for the tool
Meetings intersections(const OffsetElement& first, const OffsetElement& second, Vec2 point);

/// Returns the nearest intersection of the offsets of two elements, as a vector from `point`, where the elements meet.
///   returns  nullopt if they do not meet, or one of them is an arc too small for the tool
///   law      the intersection lies on both offsets within tol::same_point
std::optional<Vec2> intersection(const OffsetElement& first, const OffsetElement& second, Vec2 point);

/// How two elements meet, for a tool on one side (15.5.0): alpha above 180°, from 90° to 180°, below 90°.
enum class Corner : std::uint8_t { inside, obtuse, acute };
Corner corner_of(Vec2 end_tangent, Vec2 start_tangent, double side);

/// The vectors at a junction, in order; the tool's centre moves straight from one to the next.
struct JunctionVectors {
  std::array<Vec2, 8> at{};  // four at a corner; more if the interference check joins two corners (15.5.7)
  std::uint8_t count = 0;
  bool round = false;  // from the first to the second by an arc about the programmed point
  void add(Vec2 v) { at[count++] = v; }
  Vec2 first() const { return at[0]; }
  Vec2 last() const { return at[count - 1U]; }
};
inline JunctionVectors single(Vec2 vector) {
  JunctionVectors v;
  v.add(vector);
  return v;
}

/// Returns the vectors without those that differ from the previous one by less than `least` mm in both axes (N1405 DELTV, 15.5.2; which
/// of the two remains is INFERRED).
JunctionVectors without_short_steps(const JunctionVectors& vectors, double least);

/// Returns the vectors in offset mode, both elements on the same side (15.5.2).
///   returns  nullopt for an inside corner whose offsets do not meet (alarm 2047)
std::optional<JunctionVectors> junction(const ContourElement& first, const ContourElement& second, double radius, double side);

/// Returns the vectors at the end of the block that switches compensation on, a line (15.5.1, type B of the INFERRED rule).
JunctionVectors start_up(const ContourElement& first, const ContourElement& second, double radius, double side);

/// Returns the vectors at the end of the last compensated block, before the line that switches it off (15.5.3, type B).
JunctionVectors cancel(const ContourElement& first, const ContourElement& second, double radius, double side);

/// Returns the vectors of a control that joins the offset path at an outside corner by an arc, or by straight lines extended until they
/// meet (2С42 6.6.7, RS274/NGC). Next to an arc the line is the arc's tangent.
///   returns  nullopt for an inside corner whose offsets do not meet, and for an outside one whose lines meet too far away
///   law      no point of the joint is nearer to the programmed point than the radius
std::optional<JunctionVectors> joined(const ContourElement& first, const ContourElement& second, double radius, double side,
                                      CornerJoin join);

/// Returns the direction of the tool's path to a position next to a point, where it shall touch the line that ends at that point along
/// its whole length (RS274/NGC, first move into compensation).
///   way      from the tool's position to the programmed point, mm
///   returns  a unit vector; nullopt if the point is no further away than the radius
std::optional<Vec2> entry_direction(Vec2 way, double radius, double side);

/// Returns true if the tool fits in: its path along the element, between the two vectors, goes forward, and no arc is smaller than the
/// tool.
bool fits(const ContourElement& element, Vec2 start_vector, Vec2 end_vector, double radius, double side);

/// Returns true if the path from one vector to the other lies on the element's offset and goes forward along it.
bool lies_on_offset(const ContourElement& element, Vec2 start_vector, Vec2 end_vector, double radius, double side);

/// Returns true if the two elements turn by at most half a turn in total: after their junction they cannot meet again.
bool gentle(const ContourElement& first, const ContourElement& second);

/// Returns the swept angle / 360 of an arc's compensated path, counter-clockwise positive. It may exceed that of the arc, or change its
/// sign if the tool does not fit (15.5.0, 15.5.7).
double compensated_turns(const ContourElement& arc, Vec2 start_vector, Vec2 end_vector);

}  // namespace kadr
