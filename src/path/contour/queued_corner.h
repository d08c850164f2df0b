#pragma once
// Corners of a contour as LinuxCNC makes them (spec/linuxcnc 7.5; convert_straight_comp2, convert_arc_comp2 of its source): by the angle of
// the gap on the tool's side, from where the tool would stand at the end of the element before, uncut.
//
//      outer: an arc about p            straight on: nothing           inner: both are cut at `at`
//        ───────╮ (tool)                  ──────┬──────                   (tool) ──┼ at
//        ──── p │                         ───── p ─────                             │
//             │ │                                                         ───────── p
//
// A vector's components are those of the plane's axes, mm; side: +1 the tool is left of the path, -1 right.

#include <cstdint>
#include <optional>

#include "base/alarm.h"
#include "base/result.h"
#include "base/vec.h"

namespace kadr {

/// A way of the tool along an arc.
struct QueuedArc {
  Vec2 end, center;
  int turn = 1;  // begun turns, counter-clockwise positive
};

/// From one point of a circle to another, in radians, counter-clockwise positive; a whole turn where they coincide, and for each further
/// one of `turn` (find_turn).
double swept_by(Vec2 from, Vec2 center, int turn, Vec2 to);

/// Where the tool stands in the way of the contour's next element.
struct CornerPlace {
  Vec2 point;                         // the programmed corner
  Vec2 tool;                          // beside it, at the end of the element before
  double radius = 0, side = 1;        // of the tool
  std::optional<QueuedArc> arc = {};  // the tool's way along the element before, if that is one
  bool held = true;                   // that way may still be changed
};

enum class CornerWay : std::uint8_t { inner, outer, straight };

struct QueuedCorner {
  CornerWay way = CornerWay::straight;
  Vec2 at;   // inner: where both elements end; outer: where the second one begins
  Vec2 end;  // of the second one, uncut
};

/// The next element is a line to that point, another one than the corner.
///   alarms  gouge_arc_to_line: the tool does not fit in
Result<QueuedCorner> corner_to_line(const CornerPlace& place, Vec2 to);

/// The next element is an arc; `arc.end` is its programmed end.
///   alarms  arc_within_tool, gouge_arc, gouge_arc_to_arc, arcs_same_center
Result<QueuedCorner> corner_to_arc(const CornerPlace& place, const QueuedArc& arc);

/// The tool runs on the side of the arc's centre.
inline bool inside_arc(double side, int turn) { return side > 0 ? turn > 0 : turn < 0; }

/// The arc by which the tool comes onto the contour, where the programmed one is `arc` (convert_arc_comp1): it ends beside the end on the
/// line to the programmed centre, and is an arc from where the tool stands.
///   alarms  entry_arc_within_tool, arc_within_tool
Result<QueuedArc> entry_arc(Vec2 from, const QueuedArc& arc, double radius, double side);

}  // namespace kadr
