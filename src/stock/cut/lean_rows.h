#pragma once
// Where lines lie within what a body of a tool that leans sweeps. Single precision, lengths mm, seen from the tool: its axis is Z. Places
// on a line are mm from its middle.
//
// What a convex body sweeps along a straight way is convex: where a line leaves it lies on the body as it stands at one of both ends, on
// what the rim of a flat face sweeps, or on what its outline against the way does. Each of these belongs to a convex piece within the whole
// that a line meets in closed form, and the whole interval reaches from the least of their ends to the greatest. Only rounded edges are
// sought for: the distance from them is convex along the line, so that Newton's steps come to it from without.
//
//   law  a place in an interval is within the body at some part of the way, to 2e-4 mm   (tests/stock/lean_sweep_test)

#include "stock/cut/lean_body.h"
#include "stock/cut/sweep_search.h"
#include "stock/cut/upright_rows.h"

namespace kadr::lanes {

template <class V>
struct Vec3Of {
  V x, y, z;
};
template <class V>
KADR_IN_LANES V dot(const Vec3Of<V>& a, const Vec3Of<V>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class V>
KADR_IN_LANES Vec3Of<V> across(const Vec3Of<V>& a, const Vec3Of<V>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class V>
KADR_IN_LANES Vec3Of<V> plus(const Vec3Of<V>& a, const V& by, const Vec3Of<V>& b) {
  return {a.x + by * b.x, a.y + by * b.y, a.z + by * b.z};
}

inline constexpr float nearly_along = 1e-11f;  // of a sine²: a line along an axis
inline constexpr float shortest_way = 1e-6f;   // mm

/// Away from 0, so that it can be divided by.
template <class V>
KADR_IN_LANES V guarded(const V& v, float by = nearly_none) {
  return choose(v < 0.f, least(v, spread<V>(-by)), most(v, spread<V>(by)));
}

/// A slope that places are divided by.
template <class V>
struct Slant {
  V slope, per;
};
template <class V>
KADR_IN_LANES Slant<V> slant(const V& slope) {
  return {slope, 1.f / guarded(slope)};
}

/// Lines in one direction, and the way of the tool past each of them.
template <class V>
struct LeanLines {
  Vec3Of<V> direction;  // of length 1, seen from the tool in the middle of its way
  Slant<V> first_rise, last_rise;
  Vec3Of<V> first_direction, last_direction;  // … at its ends
  Vec3Of<V> way;                              // of the tool, to the end of its shift
  Vec3Of<V> forth;                            // unit vector of it
  V length, flat, per_flat;
  MarksOf<V> moves, moves_flat;
};
template <class V>
KADR_IN_LANES void set_way(LeanLines<V>& l, const Vec3Of<V>& way) {
  l.way = way, l.length = square_root(dot(way, way)), l.flat = square_root(way.x * way.x + way.y * way.y);
  const V per = 1.f / most(l.length, spread<V>(shortest_way));
  l.forth = {way.x * per, way.y * per, way.z * per};
  l.per_flat = 1.f / most(l.flat, spread<V>(shortest_way));
  l.moves = l.length > shortest_way, l.moves_flat = l.flat > shortest_way;
}
template <class V>
KADR_IN_LANES LeanLines<V> lean_lines(const Vec3Of<V>& direction, const Vec3Of<V>& first_direction, const Vec3Of<V>& last_direction,
                                      const Vec3Of<V>& way) {
  LeanLines<V> l;
  l.direction = direction, l.first_direction = first_direction, l.last_direction = last_direction;
  l.first_rise = slant(first_direction.z), l.last_rise = slant(last_direction.z);
  set_way(l, way);
  return l;
}

/// The middle of a line, seen from the tool at both ends of its way; `at`: with which it shifts by the way, as if it did not turn.
template <class V>
struct LeanPlace {
  Vec3Of<V> at, first, last;
};

template <class V>
KADR_IN_LANES Swept<V> everywhere() {
  return {spread<V>(-missed), spread<V>(missed)};
}
template <class V>
KADR_IN_LANES Swept<V> both(const Swept<V>& a, const Swept<V>& b) {
  return {most(a.from, b.from), least(a.to, b.to)};
}
/// Of two pieces of the whole.
template <class V>
KADR_IN_LANES Swept<V> either(const Swept<V>& a, const Swept<V>& b) {
  const MarksOf<V> meets = b.from <= b.to;
  return {choose(meets, least(a.from, b.from), a.from), choose(meets, most(a.to, b.to), a.to)};
}

/// Where start + place * slope is not below 0.
template <class V>
KADR_IN_LANES void clip(Swept<V>& s, const V& start, const V& slope) {
  const V at = -start / guarded(slope);
  const MarksOf<V> rises = slope >= 0.f;
  s = {choose(rises, most(s.from, at), s.from), choose(rises, s.to, least(s.to, at))};
}
/// Where it is from 0 to `most_value`.
template <class V>
KADR_IN_LANES void clip_between(Swept<V>& s, const V& start, const V& most_value, const Slant<V>& slope) {
  const V a = -start * slope.per, b = (most_value - start) * slope.per;
  s = {most(s.from, least(a, b)), least(s.to, most(a, b))};
}

/// Within a circle about the axis: of places `start` + t `way` in a plane, and the way's length².
template <class V>
KADR_IN_LANES Swept<V> in_circle(const V& x, const V& y, const V& way_x, const V& way_y, const V& square, const V& radius) {
  const V cross = x * way_y - y * way_x, room = radius * radius * square - cross * cross, per = 1.f / most(square, spread<V>(nearly_along));
  const V middle = -(x * way_x + y * way_y) * per, half = root(room) * per;
  const MarksOf<V> along = square < nearly_along, inside = x * x + y * y < radius * radius;
  return {choose(along, choose(inside, spread<V>(-missed), spread<V>(missed)), choose(room > 0.f, middle - half, spread<V>(missed))),
          choose(along, choose(inside, spread<V>(missed), spread<V>(-missed)), choose(room > 0.f, middle + half, spread<V>(-missed)))};
}

/// Where the line is not farther from the axis than a cone's side, which widens by `widens` for each mm of height.
template <class V>
KADR_IN_LANES Swept<V> in_cone(const Vec3Of<V>& at, const Vec3Of<V>& e, float radius, float bottom, float widens) {
  const V here = spread<V>(radius) + (at.z - bottom) * widens, grows = e.z * widens;
  const V a = e.x * e.x + e.y * e.y - grows * grows, b = at.x * e.x + at.y * e.y - here * grows;
  // Of the three products b² - a c, with what they have in common left out.
  const V cross = at.x * e.y - at.y * e.x, u = at.x * grows - here * e.x, v = at.y * grows - here * e.y;
  const V room = u * u + v * v - cross * cross, r = root(room);
  const V c = at.x * at.x + at.y * at.y - here * here, q = -(b + choose(b < 0.f, -r, r));
  const V one = q / guarded(a), other = c / guarded(q), first = least(one, other), last = most(one, other);
  const MarksOf<V> narrow = a > 0.f, grows_on = grows > 0.f, meets = (room >= 0.f) | (a < 0.f);
  const V from = choose(narrow, first, choose(grows_on, last, spread<V>(-missed)));
  const V to = choose(narrow, last, choose(grows_on, spread<V>(missed), first));
  return where(meets, from, to);
}

template <class V>
KADR_IN_LANES Swept<V> in_frustum(const Vec3Of<V>& at, const Vec3Of<V>& e, const Slant<V>& rise, const Frustum& f, float widens) {
  Swept<V> s;
  if (widens == 0.f) s = in_circle(at.x, at.y, e.x, e.y, e.x * e.x + e.y * e.y, spread<V>(f.low_radius));
  else s = in_cone(at, e, f.low_radius, f.low, widens);
  clip_between(s, at.z - f.low, spread<V>(f.high - f.low), rise);
  return s;
}

/// A flat face that shifts: at every height one circle.
template <class V>
KADR_IN_LANES Swept<V> in_shifted_disc(const LeanLines<V>& l, const Vec3Of<V>& at, float height, float radius) {
  // Places s on the line and t on the way where the face is at the line: s e.z - t forth.z = height - at.z; the foot, and from there.
  const V e = l.direction.z, f = l.forth.z, square = e * e + f * f, per = 1.f / most(square, spread<V>(nearly_none)), up = height - at.z;
  const V n = square_root(square), per_n = 1.f / most(n, spread<V>(shortest_way)), s = e * up * per, t = -f * up * per;
  const V slope_s = f * per_n, slope_t = e * per_n;
  const V x = at.x + s * l.direction.x - t * l.forth.x, y = at.y + s * l.direction.y - t * l.forth.y;
  const V way_x = slope_s * l.direction.x - slope_t * l.forth.x, way_y = slope_s * l.direction.y - slope_t * l.forth.y;
  Swept<V> in = in_circle(x, y, way_x, way_y, way_x * way_x + way_y * way_y, spread<V>(radius));
  clip_between(in, t, l.length, slant(slope_t));
  const V a = s + in.from * slope_s, b = s + in.to * slope_s;
  return where((in.from <= in.to) & (n > shortest_way) & l.moves, least(a, b), most(a, b));
}

/// What the outline of the side, seen along the way, sweeps: two straight lines of the side.
template <class V>
KADR_IN_LANES Swept<V> in_shifted_outline(const LeanLines<V>& l, const Vec3Of<V>& at, const Frustum& f, float widens) {
  const Vec3Of<V>& e = l.direction;
  const V ux = l.way.x * l.per_flat, uy = l.way.y * l.per_flat, one = spread<V>(1.f);
  const V facing = l.way.z * l.per_flat * widens, beside_square = one - facing * facing, beside = root(beside_square);
  const V per = l.per_flat / most(beside_square, spread<V>(shortest_way));
  // Their plane is at the part t of the way where along - facing * radius(height) = 0.
  const V radius = spread<V>(f.low_radius) + (at.z - f.low) * widens;
  const V part = (at.x * ux + at.y * uy - facing * radius) * per, part_slope = (e.x * ux + e.y * uy - facing * (e.z * widens)) * per;
  const V side = at.y * ux - at.x * uy, side_slope = e.y * ux - e.x * uy;
  const V height = at.z - part * l.way.z, height_slope = e.z - part_slope * l.way.z;
  const V wide = beside * (spread<V>(f.low_radius) + (height - f.low) * widens), wide_slope = beside * height_slope * widens;
  Swept<V> s = everywhere<V>();
  clip_between(s, part, one, slant(part_slope));
  clip(s, wide - side, wide_slope - side_slope);
  clip(s, wide + side, wide_slope + side_slope);
  clip_between(s, height - f.low, spread<V>(f.high - f.low), slant(height_slope));
  return where((s.from <= s.to) & l.moves_flat & (beside_square > shortest_way), s.from, s.to);
}

/// Lines that are not farther from the axis than this, on one side of it, on all of the way.
template <class V>
KADR_IN_LANES MarksOf<V> come_near(const LeanLines<V>& l, const Vec3Of<V>& at, float radius) {
  const Vec3Of<V>& e = l.direction;
  const V first = at.x * e.y - at.y * e.x, last = first - (l.way.x * e.y - l.way.y * e.x);
  const V reach = radius * square_root(e.x * e.x + e.y * e.y) + shortest_way;
  return (least(first, last) <= reach) & (most(first, last) >= -reach);
}

/// Which faces can lie in the brick.
struct FacesNear {
  bool low = true, high = true;
};

inline float widens(const Frustum& f) { return f.low_radius == f.high_radius ? 0.f : (f.high_radius - f.low_radius) / (f.high - f.low); }

template <class V>
KADR_IN_LANES Swept<V> in_frustum_at_ends(const LeanLines<V>& l, const LeanPlace<V>& place, const Frustum& f) {
  const Swept<V> first = in_frustum(place.first, l.first_direction, l.first_rise, f, widens(f));
  return either(where(first.from <= first.to, first.from, first.to), in_frustum(place.last, l.last_direction, l.last_rise, f, widens(f)));
}

/// What else it sweeps between the ends of its way.
template <class V>
KADR_IN_LANES Swept<V> in_frustum_between(const LeanLines<V>& l, const Vec3Of<V>& at, const Frustum& f, FacesNear near) {
  Swept<V> s = in_shifted_outline(l, at, f, widens(f));
  if (near.low) s = either(s, in_shifted_disc(l, at, f.low, f.low_radius));
  if (near.high) s = either(s, in_shifted_disc(l, at, f.high, f.high_radius));
  return s;
}

template <class V>
KADR_IN_LANES Swept<V> in_shifted_frustum(const LeanLines<V>& l, const LeanPlace<V>& place, const Frustum& f, FacesNear near) {
  if (!any(come_near(l, place.at, std::max(f.low_radius, f.high_radius)))) return {spread<V>(missed), spread<V>(-missed)};
  return either(in_frustum_at_ends(l, place, f), in_frustum_between(l, place.at, f, near));
}

template <class V>
KADR_IN_LANES Swept<V> in_ball(const Vec3Of<V>& at, const Vec3Of<V>& e, float radius) {
  const V along = dot(at, e);
  const Vec3Of<V> apart = plus(at, -along, e);
  const V room = spread<V>(radius * radius) - dot(apart, apart), half = root(room);
  return where(room > 0.f, -along - half, half - along);
}

template <class V>
KADR_IN_LANES Swept<V> in_shifted_ball(const LeanLines<V>& l, LeanPlace<V> place, float middle, float radius) {
  const Vec3Of<V>& e = l.direction;
  Vec3Of<V>& at = place.at;
  place.first.z = place.first.z - middle, place.last.z = place.last.z - middle, at.z = at.z - middle;
  const Vec3Of<V> m = across(e, l.forth), moment = across(at, l.forth);
  const V square = dot(m, m), per = 1.f / most(square, spread<V>(nearly_along)), apart = dot(at, m);
  const V room = radius * radius * square - apart * apart, half = root(room) * per, nearest = -dot(moment, m) * per;
  const MarksOf<V> along = square < nearly_along;
  const MarksOf<V> meets = (along & (dot(moment, moment) < radius * radius)) | (~along & (room > 0.f));
  Swept<V> tube{choose(along, spread<V>(-missed), nearest - half), choose(along, spread<V>(missed), nearest + half)};
  clip_between(tube, dot(at, l.forth), l.length, slant(dot(e, l.forth)));
  const Swept<V> ends = either(in_ball(place.first, l.first_direction, radius), in_ball(place.last, l.last_direction, radius));
  return either(ends, where(meets & l.moves & (tube.from <= tube.to), tube.from, tube.to));
}

// ---- rounded edges

/// The part of the way on which the body's top is not below the line's place; a bound that moves with the place.
template <class V>
struct UnderTop {
  V first, last;
};

inline constexpr int most_newton = 24;
inline constexpr float on_surface = 5e-5f;  // mm

/// Distance² from the shaft that begins at the middle of the edge, at a place of the line as the tool has gone `t` of its way.
template <class V>
struct FromShaft {
  V beside, below;  // both at least 0
  V out_x, out_y;   // unit vector of `beside`
};
template <class V>
KADR_IN_LANES FromShaft<V> from_shaft(const LeanLines<V>& l, const LeanBody& b, const Vec3Of<V>& place, const V& t) {
  const Vec3Of<V> at = plus(place, -t, l.forth);
  const V radius = square_root(at.x * at.x + at.y * at.y), per = 1.f / most(radius, spread<V>(shortest_way));
  return {most(radius - b.flat, spread<V>(0.f)), least(at.z - b.middle, spread<V>(0.f)), at.x * per, at.y * per};
}

/// From without, one end of the interval in which the line is within `corner` of the shaft. `sign`: the direction on the line outwards.
template <class V>
KADR_IN_LANES V end_of_rounded(const LeanLines<V>& l, const LeanBody& b, const Vec3Of<V>& at, const MarksOf<V>& sought, const V& start,
                               float sign) {
  const V none = spread<V>(0.f), up = l.forth.z, per_up = 1.f / guarded(up), error = spread<V>(on_surface);
  const MarksOf<V> rises = up > 0.f, level = (up < shortest_way) & (up > -shortest_way);
  V place = start;
  MarksOf<V> open = sought;
  for (int step = 0; step < most_newton; ++step) {
    const Vec3Of<V> here = plus(at, place, l.direction);
    const V bound = (here.z - b.shaft.high) * per_up;
    const V first = choose(rises & ~level, within(bound, none, l.length), none);
    const V last = choose(rises | level, l.length, within(bound, none, l.length));
    const auto slope_at = [&](const V& t) {
      const FromShaft<V> from = from_shaft(l, b, here, t);
      return Slope<V>{from.beside * (from.out_x * l.forth.x + from.out_y * l.forth.y) + from.below * up, from.beside >= 0.f};
    };
    const Slope<V> at_first = slope_at(first), at_last = slope_at(last);
    const MarksOf<V> begins = at_first.value <= 0.f, ends = ~begins & (at_last.value >= 0.f), between = open & ~begins & ~ends;
    V t = choose(begins, first, last);
    if (any(between)) t = choose(between, farthest_place(first, last, at_first, at_last, between, b.place_error, slope_at), t);
    const FromShaft<V> from = from_shaft(l, b, here, t);
    const V far = square_root(from.beside * from.beside + from.below * from.below), distance = far - b.corner;
    const Vec3Of<V>& e = l.direction;
    V grows = from.beside * (from.out_x * e.x + from.out_y * e.y) + from.below * e.z;
    // Where the top holds the tool back it moves with the place.
    const V towards = from.beside * (from.out_x * l.forth.x + from.out_y * l.forth.y) + from.below * up;
    const MarksOf<V> held = ~level & choose(rises, begins & (bound > 0.f), ends & (bound < l.length));
    grows = grows - choose(held, towards * e.z * per_up, none);
    const V outward = grows * sign / most(far, spread<V>(shortest_way));
    const MarksOf<V> outside = open & (distance > error), lost = outside & (outward <= shortest_way);
    place = choose(lost, spread<V>(-sign * missed), place);
    open = outside & ~lost;
    if (!any(open)) break;
    place = choose(open, place - sign * (distance / most(outward, spread<V>(shortest_way))), place);
  }
  return place;
}

template <class V>
KADR_IN_LANES Swept<V> in_shifted_rounded(const LeanLines<V>& l, const LeanBody& b, const LeanPlace<V>& place) {
  const Frustum around{b.middle - b.corner, b.shaft.high, b.shaft.low_radius, b.shaft.low_radius};
  const Swept<V> bound = in_shifted_frustum(l, place, around, {});
  const MarksOf<V> meets = bound.from < bound.to;
  if (!any(meets)) return bound;
  const V to = end_of_rounded(l, b, place.at, meets, bound.to, 1.f);
  const MarksOf<V> still = meets & (to > -missed);
  const V from = end_of_rounded(l, b, place.at, still, bound.from, -1.f);
  return where(still & (from < to), from, to);
}

template <class V, LeanBody::Kind kind>
KADR_IN_LANES Swept<V> lean_swept(const LeanLines<V>& l, const LeanBody& b, const LeanPlace<V>& at, FacesNear near) {
  if constexpr (kind == LeanBody::Kind::cylinder) return in_shifted_frustum(l, at, b.shaft, near);
  if constexpr (kind == LeanBody::Kind::rounded) return in_shifted_rounded(l, b, at);
  if constexpr (kind == LeanBody::Kind::ball)
    return either(in_shifted_ball(l, at, b.middle, b.corner), in_shifted_frustum(l, at, b.shaft, {false, near.high}));
  Swept<V> s = in_shifted_frustum(l, at, b.end, {});
  if (b.shaft.high > b.shaft.low) s = either(s, in_shifted_frustum(l, at, b.shaft, {false, near.high}));
  return s;
}

/// The same in two parts: as the tool stands at the ends of its way, which does not depend on how it shifts, and between them.
template <class V, LeanBody::Kind kind>
KADR_IN_LANES Swept<V> lean_at_ends(const LeanLines<V>& l, const LeanBody& b, const LeanPlace<V>& at) {
  if constexpr (kind == LeanBody::Kind::cylinder) return in_frustum_at_ends(l, at, b.shaft);
  if constexpr (kind == LeanBody::Kind::rounded) {
    // Cylinders within it: a line that all but lies in its side or its flat face may leave that the other way where the tool does not turn.
    const Frustum core{b.middle - b.corner, b.shaft.high, b.flat, b.flat};
    Swept<V> s{spread<V>(missed), spread<V>(-missed)};
    if (b.flat > 0) s = either(s, in_frustum_at_ends(l, at, core));
    return b.shaft.high > b.shaft.low ? either(s, in_frustum_at_ends(l, at, b.shaft)) : s;
  }
  const Swept<V> end = in_frustum_at_ends(l, at, b.end);
  return b.shaft.high > b.shaft.low ? either(end, in_frustum_at_ends(l, at, b.shaft)) : end;
}
template <class V, LeanBody::Kind kind>
KADR_IN_LANES Swept<V> lean_between(const LeanLines<V>& l, const LeanBody& b, const LeanPlace<V>& at, FacesNear near) {
  if constexpr (kind == LeanBody::Kind::cylinder) return in_frustum_between(l, at.at, b.shaft, near);
  if constexpr (kind == LeanBody::Kind::rounded) return in_shifted_rounded(l, b, at);
  const Swept<V> end = in_frustum_between(l, at.at, b.end, {});
  return b.shaft.high > b.shaft.low ? either(end, in_frustum_between(l, at.at, b.shaft, {false, near.high})) : end;
}

}  // namespace kadr::lanes
