#pragma once
// Corners of a contour as LinuxCNC computes them (spec/linuxcnc 7.5; convert_straight_comp2, convert_arc_comp2 of its source): by the
// angle of the gap on the tool's side, measured from the tool's position at the uncut end of the previous element.
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

/// The tool's path along an arc.
struct QueuedArc {
  Vec2 end, center;
  int turn = 1;  // started turns, counter-clockwise positive
};

/// Returns the angle from one point of a circle to another, rad, counter-clockwise positive; a full turn if they coincide, plus a full
/// turn for each further one of `turn` (find_turn).
double swept_by(Vec2 from, Vec2 center, int turn, Vec2 to);

/// The situation at a corner: where the tool is, relative to the next element of the contour.
struct CornerPlace {
  Vec2 point;                         // the programmed corner
  Vec2 tool;                          // next to the corner, at the end of the previous element
  double radius = 0, side = 1;        // of the tool
  std::optional<QueuedArc> arc = {};  // the tool's path along the previous element, if that is an arc
  bool held = true;                   // that path may still be changed
};

enum class CornerWay : std::uint8_t { inner, outer, straight };

struct QueuedCorner {
  CornerWay way = CornerWay::straight;
  Vec2 at;   // inner: where both elements end; outer: where the second one starts
  Vec2 end;  // uncut end of the second element
};

/// Returns the corner to a line that ends at `to`, which must differ from the corner point.
///   alarms  gouge_arc_to_line: the tool does not fit in
Result<QueuedCorner> corner_to_line(const CornerPlace& place, Vec2 to);

/// Returns the corner to an arc; `arc.end` is the arc's programmed end.
///   alarms  arc_within_tool, gouge_arc, gouge_arc_to_arc, arcs_same_center
Result<QueuedCorner> corner_to_arc(const CornerPlace& place, const QueuedArc& arc);

/// True if the tool is on the side of the arc's centre.
inline bool inside_arc(double side, int turn) { return side > 0 ? turn > 0 : turn < 0; }

/// Returns the arc by which the tool enters the contour, where the programmed arc is `arc` (convert_arc_comp1): it ends next to the
/// programmed end, on the line to the programmed centre, and is an arc that starts at the tool's position.
///   alarms  entry_arc_within_tool, arc_within_tool
Result<QueuedArc> entry_arc(Vec2 from, const QueuedArc& arc, double radius, double side);

}  // namespace kadr
