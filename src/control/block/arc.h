#pragma once
// The geometry of one programmed arc: centre, sweep, checks. Plain numbers in the plane; no words, no state.

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

/// How a control reads the centre of an arc and what it lets pass.
struct ArcRule {
  bool by_words = false;        // its words, the block's modes and nothing else say where it is
  bool absolute = false;        // they are coordinates; else distances from the start
  bool lead_on_normal = false;  // that on the normal axis is the lead of a helix (2С42 6.6.6)
  double difference = 0;        // mm; how far the radii at start and end may differ
  bool even_angle = false;      // where they differ the angle goes evenly (nct 4.3); else the feed is that of the path
};

/// By more than rounding.
inline bool radius_changes(Vec2 from, Vec2 to, Vec2 center) {
  return std::fabs(length(to - center) - length(from - center)) > tol::same_point;
}

/// Arc from `from` to `to` around `center`; a full circle if the two coincide.
///   from, to, center  mm, in the plane
///   turn              seen from the positive end of the plane's normal
///   max_difference    mm; how far the radii at start and end may differ
///   alarms            radius_mismatch (both radii), arc_radius_zero
///   law               from and to exchanged, turn opposed: the same arc, reversed
Result<PlaneArc> arc_around(Vec2 from, Vec2 to, Vec2 center, Turn turn, double max_difference);

/// Arc of that radius; negative: the longer of the two (RS274/NGC).
///   alarms  full_circle_by_radius, radius_too_small (radius, half the chord)
Result<PlaneArc> arc_by_radius(Vec2 from, Vec2 to, double radius, Turn turn, double max_difference);

}  // namespace kadr
