#pragma once
// The geometry of one programmed arc: centre, swept angle, checks. The functions work on plain numbers in the plane, without words or
// state.

#include <cmath>

#include "base/result.h"
#include "base/tolerance.h"
#include "base/vec.h"

namespace kadr {

enum class Turn : std::uint8_t { cw, ccw };

struct PlaneArc {
  Vec2 center;
  double turns = 0;  // swept angle in revolutions (degrees / 360), positive; 1 for a full circle
};

/// The ends of an arc in its plane, mm, and the direction of the motion.
struct ArcEnds {
  Vec2 from, to;
  Turn turn = Turn::cw;
};

/// The rule by which a control reads the centre of an arc, and the inaccuracy that it accepts.
struct ArcRule {
  // true: the centre depends only on the words of the block and on the modes; the fast path (block/motion_run) requires this
  bool by_words = false;
  // true: an arc with the word R, without I, J and K, depends only on the words of the block and on the modes
  bool radius_by_words = false;
  bool absolute = false;        // true: I, J, K are coordinates of the centre; false: distances from the start point
  bool lead_on_normal = false;  // the I, J or K of the axis normal to the plane is the lead of a helix, mm per revolution (2С42 6.6.6)
  double difference = 0;        // greatest allowed difference between the radii at the start and at the end, mm
  // Speed on an arc with unequal radii: true: constant angular speed (nct 4.3); false: constant feed along the path.
  bool even_angle = false;
};

/// Returns true if the radii at the start and at the end of the arc differ by more than the numerical tolerance.
inline bool radius_changes(Vec2 from, Vec2 to, Vec2 center) {
  return std::fabs(length(to - center) - length(from - center)) > tol::same_point;
}

/// Returns the arc from `from` to `to` around `center`; a full circle if the two points coincide.
///   from, to, center  mm, in the plane
///   turn              direction, seen from the positive end of the plane's normal
///   max_difference    mm; greatest difference that is allowed between the radii at start and end
///   alarms            radius_mismatch (its arguments are both radii), arc_radius_zero
///   law               if from and to are exchanged and turn is reversed, the result is the same arc, reversed
Result<PlaneArc> arc_around(Vec2 from, Vec2 to, Vec2 center, Turn turn, double max_difference);

/// Returns the arc with the given radius. A negative radius selects the longer of the two possible arcs (RS274/NGC).
///   alarms  full_circle_by_radius; radius_too_small (its arguments are the radius and half the chord)
Result<PlaneArc> arc_by_radius(Vec2 from, Vec2 to, double radius, Turn turn, double max_difference);

}  // namespace kadr
