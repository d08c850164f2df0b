// Computes the geometry of one programmed arc: centre, swept angle, checks. Used by the rest of control; tested by
// tests/control/arc_test.cpp.

#include "control/block/arc.h"

#include <cmath>

#include "base/tolerance.h"

namespace kadr {
namespace {

/// Returns the angle from vector `a` to vector `b` in the direction of `turn`, in degrees, in the range (0, 360].
double sweep_deg(Vec2 a, Vec2 b, Turn turn) {
  const double ccw = angle_deg({dot(a, b), cross(a, b)});
  const double sweep = turn == Turn::ccw ? ccw : -ccw;
  return sweep > tol::same_angle ? sweep : sweep + 360;
}

}  // namespace

Result<PlaneArc> arc_around(Vec2 from, Vec2 to, Vec2 center, Turn turn, double max_difference) {
  const Vec2 first = from - center;
  const Vec2 last = to - center;
  const double r0 = length(first);
  const double r1 = length(last);
  if (r0 <= tol::same_point && r1 <= tol::same_point) return fail(alarm(AlarmId::arc_radius_zero, {}));
  if (!(std::fabs(r0 - r1) <= max_difference)) return fail(alarm(AlarmId::radius_mismatch, {}, r0, r1));
  if (length(to - from) <= tol::same_point) return PlaneArc{center, 1};
  return PlaneArc{center, sweep_deg(first, last, turn) / 360};
}

Result<PlaneArc> arc_by_radius(Vec2 from, Vec2 to, double radius, Turn turn, double max_difference) {
  const Vec2 chord = to - from;
  const double distance = length(chord);
  if (distance <= tol::same_point) return fail(alarm(AlarmId::full_circle_by_radius, {}));
  const double half = distance / 2;
  double r = std::fabs(radius);
  if (r < half - max_difference || r <= tol::same_point) return fail(alarm(AlarmId::radius_too_small, {}, r, half));
  r = std::max(r, half);
  const double rise = std::sqrt((r - half) * (r + half));    // the form r*r - half*half would lose digits near a half circle
  const Vec2 left{-chord.y / distance, chord.x / distance};  // unit vector normal to the chord, to the left of its direction
  // A counter-clockwise arc below 180° has its centre on the left of the chord, a longer one on the right; for a clockwise arc the sides
  // are exchanged.
  const bool center_left = (turn == Turn::ccw) == (radius > 0);
  const Vec2 center = from + 0.5 * chord + (center_left ? rise : -rise) * left;
  return PlaneArc{center, sweep_deg(from - center, to - center, turn) / 360};
}

}  // namespace kadr
