#pragma once
// Finds the intervals of lattice lines along Z inside the volume that a body of an upright tool sweeps along a straight path. Numbers have
// single precision; lengths are in mm from the brick's corner.
//
//   law  a point in an interval is inside the body at some position on the path, to within 2e-4 mm (tests/stock/sweep_test)

#include "stock/cut/sweep_search.h"
#include "stock/cut/swept_body.h"

namespace kadr::lanes {

inline constexpr float missed = 1e30f;

/// The swept interval of each lattice line; `from` is greater than `to` if the body misses the line.
template <class V>
struct Swept {
  V from, to;
};

template <class V>
KADR_IN_LANES Swept<V> where(const MarksOf<V>& meets, const V& from, const V& to) {
  return {choose(meets, from, spread<V>(missed)), choose(meets, to, spread<V>(-missed))};
}

/// The section of the path on which the body is over a lattice line.
template <class V>
struct Over {
  // Position on the path where the tool's axis is nearest to the line (mm); squared distance of the axis and the line at this position
  // (mm²).
  V nearest, apart;
  V first, last;
  MarksOf<V> meets;
};

template <class V>
KADR_IN_LANES Over<V> over_line(const LocalSweep& s, const V& x, float y, float radius) {
  const float wx = s.flat_direction[0], wy = s.flat_direction[1], per_square = s.per_flat * s.per_flat, dy = y - s.from[1];
  const V dx = x - s.from[0], none = spread<V>(0.f), nearest = (dx * wx + spread<V>(dy * wy)) * per_square;
  const V aside = dx * wy - spread<V>(dy * wx);
  const V apart = s.upright ? dx * dx + spread<V>(dy * dy) : aside * aside * per_square;
  const V room = spread<V>(radius * radius) - apart, half = root(room) * s.per_flat;
  const V first = most(nearest - half, none), last = least(nearest + half, spread<V>(s.length));
  return {nearest, apart, first, last, (room > 0.f) & (first <= last)};
}

/// mm by which the side of a cone is moved outwards. Without this margin, a distance from the axis that was rounded up would give too great
/// a height on a nearly vertical side.
inline constexpr float rounded_radius = 1e-5f;

/// Returns the height in mm of the surface of the body's end, above the bottom of the end, at the distance `radius` from the axis.
template <class V, BodyEnd end>
KADR_IN_LANES V end_height(const SweptBody& b, const V& radius) {
  const V beyond = most(radius - (end == BodyEnd::cone ? b.flat + rounded_radius : b.flat), spread<V>(0.f));
  if constexpr (end == BodyEnd::cone) return least(beyond * b.stands, spread<V>(b.tall()));
  if constexpr (end == BodyEnd::torus || end == BodyEnd::ball)
    return spread<V>(b.corner) - root(spread<V>(b.corner * b.corner) - beyond * beyond);
  return spread<V>(0.f);
}

/// Returns the position on the path at which the corner radius of the body is lowest over the line.
template <class V>
KADR_IN_LANES V lowest_of_torus(const LocalSweep& s, const SweptBody& b, const Over<V>& over) {
  const float square = s.flat * s.flat, corner_square = b.corner * b.corner;
  const auto slope_at = [&](const V& at) {
    const V q = at - over.nearest, r = square_root(over.apart + q * q * square + spread<V>(1e-18f));
    const V beyond = most(r - b.flat, spread<V>(0.f)), chord = root(spread<V>(corner_square) - beyond * beyond);
    return Slope<V>{-(chord * r * s.direction[2] + beyond * q * square), beyond >= 0.f};
  };
  const Slope<V> at_first = slope_at(over.first), at_last = slope_at(over.last);
  const MarksOf<V> begins = at_first.value <= 0.f, ends = ~begins & (at_last.value >= 0.f), sought = over.meets & ~begins & ~ends;
  V place = choose(begins, over.first, over.last);
  if (any(sought))
    place = choose(sought, farthest_position(over.first, over.last, at_first, at_last, sought, b.error_at_position, slope_at), place);
  return place;
}

/// While a cone moves along a sloping path, it is lowest over a lattice line not where its axis is nearest to the line, but some distance
/// along the path from there. Returns this distance in the XY plane, per mm of the nearest distance between the axis and the line.
inline float cone_lag(const LocalSweep& s, const SweptBody& b) {
  const float steep = std::fabs(s.direction[2]) * s.per_flat * b.widens;
  return steep < 1.f ? steep / std::sqrt(std::max(1.f - steep * steep, nearly_none)) : missed;
}

/// Returns the position on the path at which the end of the body is lowest over the line.
template <class V, BodyEnd end>
KADR_IN_LANES V lowest_place(const LocalSweep& s, const SweptBody& b, const Over<V>& over) {
  const V none = spread<V>(0.f);
  if constexpr (end == BodyEnd::flat) return s.direction[2] > 0.f ? over.first : over.last;
  if constexpr (end == BodyEnd::torus) return lowest_of_torus(s, b, over);
  V before;  // distance in mm, along the path in the XY plane, from the lowest position to the nearest position; positive if the path rises
  if constexpr (end == BodyEnd::ball) {
    before = root(spread<V>(b.radius * b.radius) - over.apart) * (s.direction[2] * s.per_flat);
  } else {
    const V flat = s.direction[2] == 0.f ? none : root(spread<V>(b.flat * b.flat) - over.apart);
    const V lag = most(least(square_root(over.apart) * cone_lag(s, b), spread<V>(missed)), flat) * s.per_flat;
    before = s.direction[2] > 0.f ? lag : -lag;
  }
  return within(over.nearest - before, over.first, over.last);
}

/// Returns the intervals of lattice lines at the positions `x`, `y` that the body sweeps.
///   tip  receives, for each line, the height of the tip at the position where the body's end is lowest over the line
template <class V, BodyEnd end>
KADR_IN_LANES Swept<V> upright_lines(const LocalSweep& s, const SweptBody& b, const V& x, float y, V& tip) {
  const Over<V> over = over_line(s, x, y, b.radius);
  const V lowest = lowest_place<V, end>(s, b, over), q = lowest - over.nearest, square = over.apart + q * q * (s.flat * s.flat);
  const float base = s.from[2] + b.bottom;
  V height = spread<V>(0.f);
  if constexpr (end == BodyEnd::ball) height = spread<V>(b.corner) - root(spread<V>(b.corner * b.corner) - square);
  else if constexpr (end != BodyEnd::flat) height = end_height<V, end>(b, root(square));
  const V from = lowest * s.direction[2] + height + base;
  tip = lowest * s.direction[2] + s.from[2];
  const V to = (s.direction[2] > 0.f ? over.last : over.first) * s.direction[2] + (s.from[2] + b.top);
  return where(over.meets, from, to);
}

}  // namespace kadr::lanes
