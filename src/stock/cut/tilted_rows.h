#pragma once
// Finds the intervals of lattice lines inside the volume that a body of a tilted tool sweeps. Numbers have single precision; lengths are in
// mm, in the tool's coordinates with the tool's axis along Z. Positions on a line are in mm from the line's middle.
//
// The volume that a convex body sweeps along a straight path is convex. The point where a line leaves this volume is on the body in an end
// pose, on the volume swept by the edge circle of a flat face, or on the volume swept by the body's outline as seen along the path. Each of
// these surfaces is part of a convex volume, whose intersection with a line has an exact formula. The result is the interval from the least
// to the greatest end of these intersections. Only rounded edges need an iteration: the distance from a rounded edge is a convex function
// along the line, so Newton's method converges from outside.
//
//   law  a point in an interval is inside the body at some position on the path, to within 2e-4 mm (tests/stock/tilted_sweep_test)

#include "stock/cut/tilted_frustum.h"

namespace kadr::lanes {

template <class V>
KADR_IN_LANES Swept<V> in_ball(const Vec3Of<V>& at, const Vec3Of<V>& e, float radius) {
  const V along = dot(at, e);
  const Vec3Of<V> apart = plus(at, -along, e);
  const V room = spread<V>(radius * radius) - dot(apart, apart), half = root(room);
  return where(room > 0.f, -along - half, half - along);
}

template <class V>
KADR_IN_LANES Swept<V> in_shifted_ball(const TiltedLines<V>& l, TiltedPosition<V> place, float middle, float radius) {
  const Vec3Of<V> e = vector_of<V>(l.heading);
  const Vec3Of<V>& forth = l.past.forth;
  Vec3Of<V>& at = place.at;
  place.first.z = place.first.z - middle, place.last.z = place.last.z - middle, at.z = at.z - middle;
  const Vec3Of<V> m = across(e, forth), moment = across(at, forth);
  const V square = dot(m, m), per = 1.f / most(square, spread<V>(nearly_along)), apart = dot(at, m);
  const V room = radius * radius * square - apart * apart, half = root(room) * per, nearest = -dot(moment, m) * per;
  const MarksOf<V> along = square < nearly_along;
  const MarksOf<V> meets = (along & (dot(moment, moment) < radius * radius)) | (~along & (room > 0.f));
  Swept<V> tube{choose(along, spread<V>(-missed), nearest - half), choose(along, spread<V>(missed), nearest + half)};
  clip_between(tube, dot(at, forth), l.past.length, inverse(dot(e, forth)));
  const Swept<V> ends = either(in_ball(place.first, vector_of<V>(l.first), radius), in_ball(place.last, vector_of<V>(l.last), radius));
  return either(ends, where(meets & l.past.moves & (tube.from <= tube.to), tube.from, tube.to));
}

// ---- functions for rounded edges

/// The section of the path on which the top of the body is not below a point of the line. The ends of the section depend on the point.
template <class V>
struct UnderTop {
  V first, last;
};

inline constexpr int max_newton = 24;
inline constexpr float on_surface = 5e-5f;  // limit in mm: a point whose distance from the surface is at most this counts as on the surface

/// The vector from the nearest point of a cylinder inside the body to a point of the line, in the tool's coordinates (tool axis along Z),
/// after the tool has moved `t` mm along its path. The cylinder has the radius `flat` and begins at the height `middle`; its top is
/// ignored.
template <class V>
struct FromShaft {
  // Components in mm of the vector from the cylinder to the point: `sideways` is perpendicular to the tool axis, outwards, at least 0.
  // `below` is along the tool axis: negative if the point is below the cylinder's bottom face, otherwise 0.
  V sideways, below;
  V out_x, out_y;  // unit vector perpendicular to the tool axis, in the direction of `sideways`
};
template <class V>
KADR_IN_LANES FromShaft<V> from_shaft(const TiltedLines<V>& l, const TiltedBody& b, const Vec3Of<V>& place, const V& t) {
  const Vec3Of<V> at = plus(place, -t, l.past.forth);
  const V radius = square_root(at.x * at.x + at.y * at.y), per = 1.f / most(radius, spread<V>(shortest_path));
  return {most(radius - b.flat, spread<V>(0.f)), least(at.z - b.middle, spread<V>(0.f)), at.x * per, at.y * per};
}

/// Finds one end of the interval of a line inside a bull-nose body, that is, inside the points at most `corner` mm away from a cylinder
/// (see FromShaft). The iteration starts outside the body. `sign` is the outward direction along the line, 1 or -1.
template <class V>
KADR_OWN_FUNCTION V end_of_rounded(const TiltedLines<V>& l, const TiltedBody& b, const Vec3Of<V>& at, const MarksOf<V>& sought,
                                   const V& start, float sign) {
  const Vec3Of<V> e = vector_of<V>(l.heading);
  const Vec3Of<V>& forth = l.past.forth;
  const V length = l.past.length;
  const V none = spread<V>(0.f), up = forth.z, per_up = 1.f / guarded(up), error = spread<V>(on_surface);
  const MarksOf<V> rises = up > 0.f, level = (up < shortest_path) & (up > -shortest_path);
  V place = start;
  MarksOf<V> open = sought;
  for (int step = 0; step < max_newton; ++step) {
    const Vec3Of<V> here = plus(at, place, e);
    const V bound = (here.z - b.shaft.high) * per_up;
    const V first = choose(rises & ~level, within(bound, none, length), none);
    const V last = choose(rises | level, length, within(bound, none, length));
    const auto slope_at = [&](const V& t) {
      const FromShaft<V> from = from_shaft(l, b, here, t);
      return Slope<V>{from.sideways * (from.out_x * forth.x + from.out_y * forth.y) + from.below * up, from.sideways >= 0.f};
    };
    const Slope<V> at_first = slope_at(first), at_last = slope_at(last);
    const MarksOf<V> begins = at_first.value <= 0.f, ends = ~begins & (at_last.value >= 0.f), between = open & ~begins & ~ends;
    V t = choose(begins, first, last);
    if (any(between))
      t = choose(between, smooth_farthest_position(first, last, at_first, at_last, between, b.error_at_position, slope_at), t);
    const FromShaft<V> from = from_shaft(l, b, here, t);
    const V far = square_root(from.sideways * from.sideways + from.below * from.below), distance = far - b.corner;
    V grows = from.sideways * (from.out_x * e.x + from.out_y * e.y) + from.below * e.z;
    // Where the top of the body limits the section of the path, the nearest position on the path changes with the position on the line.
    // This change adds to the slope of the distance.
    const V towards = from.sideways * (from.out_x * forth.x + from.out_y * forth.y) + from.below * up;
    const MarksOf<V> held = ~level & choose(rises, begins & (bound > 0.f), ends & (bound < length));
    grows = grows - choose(held, towards * e.z * per_up, none);
    const V outward = grows * sign / most(far, spread<V>(shortest_path));
    const MarksOf<V> outside = open & (distance > error), lost = outside & (outward <= shortest_path);
    place = choose(lost, spread<V>(-sign * missed), place);
    open = outside & ~lost;
    if (!any(open)) break;
    place = choose(open, place - sign * (distance / most(outward, spread<V>(shortest_path))), place);
  }
  return place;
}

template <class V>
KADR_IN_LANES Swept<V> in_shifted_rounded(const TiltedLines<V>& l, const TiltedBody& b, const TiltedPosition<V>& place) {
  const Frustum around{b.middle - b.corner, b.shaft.high, b.shaft.low_radius, b.shaft.low_radius};
  const Swept<V> bound = in_shifted_frustum<V, Side::straight>(l, place, around, {});
  const MarksOf<V> meets = bound.from < bound.to;
  if (!any(meets)) return bound;
  const V to = end_of_rounded(l, b, place.at, meets, bound.to, 1.f);
  const MarksOf<V> still = meets & (to > -missed);
  const V from = end_of_rounded(l, b, place.at, still, bound.from, -1.f);
  return where(still & (from < to), from, to);
}

template <class V, TiltedBody::Kind kind>
KADR_OWN_FUNCTION Swept<V> tilted_swept(const TiltedLines<V>& l, const TiltedBody& b, const TiltedPosition<V>& at, FacesNear near) {
  if constexpr (kind == TiltedBody::Kind::cylinder) return in_shifted_frustum<V, Side::straight>(l, at, b.shaft, near);
  if constexpr (kind == TiltedBody::Kind::rounded) return in_shifted_rounded(l, b, at);
  if constexpr (kind == TiltedBody::Kind::ball)
    return either(in_shifted_ball(l, at, b.middle, b.corner), in_shifted_frustum<V, Side::straight>(l, at, b.shaft, {false, near.high}));
  Swept<V> s = in_shifted_frustum<V, Side::any>(l, at, b.end, {});
  if (b.shaft.high > b.shaft.low) s = either(s, in_shifted_frustum<V, Side::straight>(l, at, b.shaft, {false, near.high}));
  return s;
}

/// tilted_swept() consists of two parts: tilted_at_ends() uses the end poses, which do not depend on the shift; tilted_between() computes
/// what the body sweeps between these poses.
template <class V, TiltedBody::Kind kind>
KADR_OWN_FUNCTION Swept<V> tilted_at_ends(const TiltedLines<V>& l, const TiltedBody& b, const TiltedPosition<V>& at) {
  if constexpr (kind == TiltedBody::Kind::cylinder) return in_frustum_at_ends<V, Side::straight>(l, at, b.shaft);
  if constexpr (kind == TiltedBody::Kind::rounded) {
    // For the two cylinders inside a bull-nose body, the true poses at the ends of the path are used. Without the turn, a line that nearly
    // lies in the side or a flat face of a cylinder could seem to leave the cylinder in the wrong direction.
    const Frustum core{b.middle - b.corner, b.shaft.high, b.flat, b.flat};
    Swept<V> s{spread<V>(missed), spread<V>(-missed)};
    if (b.flat > 0) s = either(s, in_frustum_at_ends<V, Side::straight>(l, at, core));
    return b.shaft.high > b.shaft.low ? either(s, in_frustum_at_ends<V, Side::straight>(l, at, b.shaft)) : s;
  }
  const Swept<V> end = in_frustum_at_ends<V, Side::any>(l, at, b.end);
  return b.shaft.high > b.shaft.low ? either(end, in_frustum_at_ends<V, Side::straight>(l, at, b.shaft)) : end;
}
template <class V, TiltedBody::Kind kind>
KADR_IN_LANES Swept<V> tilted_between(const TiltedLines<V>& l, const TiltedBody& b, const TiltedPosition<V>& at, FacesNear near) {
  if constexpr (kind == TiltedBody::Kind::cylinder) return in_frustum_between<V, Side::straight>(l, at.at, b.shaft, near);
  if constexpr (kind == TiltedBody::Kind::rounded) return in_shifted_rounded(l, b, at);
  const Swept<V> end = in_frustum_between<V, Side::any>(l, at.at, b.end, {});
  return b.shaft.high > b.shaft.low ? either(end, in_frustum_between<V, Side::straight>(l, at.at, b.shaft, {false, near.high})) : end;
}

/// Returns the intervals of lines inside the body at the start and the end of the path, as if the tool shifted without turning. They differ
/// from the intervals in the true poses by the bend of the path. The computation of what the body sweeps between the poses starts from
/// these intervals.
template <class V, TiltedBody::Kind kind>
KADR_IN_LANES Swept<V> shifted_at_ends(const TiltedLines<V>& l, const TiltedBody& b, const Vec3Of<V>& at) {
  return tilted_at_ends<V, kind>({l.heading, l.heading, l.heading, l.past}, b, {at, at, plus(at, spread<V>(-1.f), l.past.travel)});
}

}  // namespace kadr::lanes
