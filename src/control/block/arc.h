#pragma once
// Geometry of one programmed arc: centre, sweep, checks. The functions work on plain numbers in the plane, without words or state.

#include <cmath>

#include "base/result.h"
#include "base/tolerance.h"
#include "base/vec.h"

namespace kadr {

enum class Turn : std::uint8_t { cw, ccw };

struct PlaneArc {
  Vec2 center;
  double turns = 0;  // swept angle / 360, positive; 1 for a full circle
};

/// How a control reads the centre of an arc, and which inaccuracy it accepts.
struct ArcRule {
  bool by_words = false;        // the centre is known from the block's words and modes alone
  bool absolute = false;        // the words of the centre are its coordinates; false: distances from the start point
  bool lead_on_normal = false;  // the word of the normal axis is the lead of a helix (2С42 6.6.6)
  double difference = 0;        // mm; maximum difference of the radii at start and end
  bool even_angle = false;      // radii differ: the angle changes at a constant rate (nct 4.3); else the feed applies along the path
};

/// Returns true if the radii at start and end differ by more than rounding.
inline bool radius_changes(Vec2 from, Vec2 to, Vec2 center) {
  return std::fabs(length(to - center) - length(from - center)) > tol::same_point;
}

/// Arc from `from` to `to` around `center`; a full circle if the two points coincide.
///   from, to, center  mm, in the plane
///   turn              seen from the positive end of the plane's normal
///   max_difference    mm; maximum difference of the radii at start and end
///   alarms            radius_mismatch (both radii), arc_radius_zero
///   law               with from and to exchanged and turn reversed: the same arc, reversed
Result<PlaneArc> arc_around(Vec2 from, Vec2 to, Vec2 center, Turn turn, double max_difference);

/// Arc with the given radius; if it is negative, the longer of the two possible arcs (RS274/NGC).
///   alarms  full_circle_by_radius, radius_too_small (radius, half the chord)
Result<PlaneArc> arc_by_radius(Vec2 from, Vec2 to, double radius, Turn turn, double max_difference);

}  // namespace kadr
