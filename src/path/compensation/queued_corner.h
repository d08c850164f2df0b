#pragma once
// This file computes the corners of a compensated contour as LinuxCNC does (spec/linuxcnc 7.5; convert_straight_comp2 and convert_arc_comp2
// of LinuxCNC's source). The type of the corner follows from the angle between the elements on the tool's side. The angle is measured from
// the tool's position at the end of the previous element, before a corner shortens this element.
//
//      outer: an arc about p            straight on: nothing           inner: both end at `at`
//        ───────╮ (tool)                  ──────┬──────                   (tool) ──┼ at
//        ──── p │                         ───── p ─────                             │
//             │ │                                                         ───────── p
//
// Vectors are in the coordinates of the plane's axes, in mm. p is the programmed corner. `side` is +1 if the tool is left of the path, and
// −1 if the tool is right of the path.

#include <cstdint>
#include <optional>

#include "base/alarm.h"
#include "base/result.h"
#include "base/vec.h"

namespace kadr {

/// The path of the tool's centre along an arc of the contour.
struct QueuedArc {
  Vec2 end, center;
  int turn = 1;  // number of revolutions that the arc has started, positive counter-clockwise
};

/// Returns the angle from one point of a circle to another point in rad, positive counter-clockwise. If the points coincide, the angle is a
/// full revolution. Each further revolution in `turn` adds a full revolution (find_turn).
double swept_by(Vec2 from, Vec2 center, int turn, Vec2 to);

/// The situation at a corner: the position of the tool relative to the next element of the contour.
struct CornerSituation {
  Vec2 point;                         // the programmed corner
  Vec2 tool;                          // Tool position next to the corner, at the end of the previous element.
  double radius = 0, side = 1;        // tool radius in mm, and side of the tool: +1 left, −1 right of the path
  std::optional<QueuedArc> arc = {};  // The tool's path along the previous element, if this element is an arc.
  bool held = true;                   // True if the tool's path along the previous element may still be changed.
};

enum class CornerKind : std::uint8_t { inner, outer, straight };

struct QueuedCorner {
  CornerKind kind = CornerKind::straight;
  // At an inner corner: the point at which the tool leaves the first element and starts the second element. At an outer corner: the point
  // at which the second element starts.
  Vec2 at;
  Vec2 end;  // End of the second element, before the next corner shortens this element.
};

/// Returns the corner before a line that ends at `to`. The point `to` must differ from the corner point.
///   alarms  gouge_arc_to_line, if the tool does not fit into the corner
Result<QueuedCorner> corner_to_line(const CornerSituation& place, Vec2 to);

/// Returns the corner before an arc; `arc.end` is the programmed end of the arc.
///   alarms  arc_within_tool, gouge_arc, gouge_arc_to_arc, arcs_same_center
Result<QueuedCorner> corner_to_arc(const CornerSituation& place, const QueuedArc& arc);

/// True if the tool is on the inner side of the arc, on which the arc's centre lies.
inline bool inside_arc(double side, int turn) { return side > 0 ? turn > 0 : turn < 0; }

/// Returns the arc along which the tool enters the contour if the first compensated motion is the programmed arc `arc` (convert_arc_comp1).
/// The entry arc starts at the tool's position `from`. It ends next to the programmed end, on the line through the programmed end and the
/// programmed centre.
///   alarms  entry_arc_within_tool, arc_within_tool
Result<QueuedArc> entry_arc(Vec2 from, const QueuedArc& arc, double radius, double side);

}  // namespace kadr
