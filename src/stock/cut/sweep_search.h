#pragma once
// Finds the position on the path at which a tool's rounded or conical end reaches farthest along a lattice line. Used by
// stock/cut/level_rows and stock/cut/upright_rows.
//
// For a convex body on a straight path, the distance that the body reaches along a line is a concave function of the position on the path.
// So the function has one maximum, and the sign of its slope at a position shows on which side of the position the maximum is. For most
// lines the slopes at both ends of the path decide. For the other lines, the section of the path that contains the maximum (the bracket) is
// narrowed step by step. The next position is the zero of the straight line (chord) through the slopes at both ends of the bracket. The
// middle of the bracket is used instead if the lattice line misses the body at one end, or if the last chord has not halved the bracket.

#include "stock/cut/float_lanes.h"

namespace kadr::lanes {

/// The slope of the distance that the body reaches along a lattice line, at one position on the path.
template <class V>
struct Slope {
  V value;            // the slope: positive if the body reaches farther along the lattice line at later positions on the path
  MarksOf<V> smooth;  // true if the line meets the body at this position, so that the slope is continuous there
};

inline constexpr int steady_steps = 2, max_steps = 48;

/// The section of the path that contains the position of farthest reach.
template <class V>
struct Bracket {
  V first, last;
  Slope<V> at_first, at_last;
};

/// Narrows the section of the path that contains the position of farthest reach, until the section is at most `error` mm long.
/// `slope_at(place)` must return the Slope at a position. Only the lines marked in `sought` are searched: there the slope is positive at
/// `place_first` and negative at `place_last`.
template <class V>
KADR_IN_LANES Bracket<V> bracketed(const V& place_first, const V& place_last, const Slope<V>& slope_first, const Slope<V>& slope_last,
                                   const MarksOf<V>& sought, float error, const auto& slope_at) {
  V first = place_first, last = place_last;
  Slope<V> at_first = slope_first, at_last = slope_last;
  const V half = spread<V>(0.5f), none = spread<V>(0.f), beyond = spread<V>(0.5f * error);
  MarksOf<V> slow = sought & ~sought;
  for (int step = 0; step < max_steps; ++step) {
    const V width = last - first, middle = half * (first + last);
    if (!any(sought & (width > error))) break;
    const V chord = within(first + width * (at_first.value / (at_first.value - at_last.value)), first, last);
    // The next position to test is moved slightly from the zero of the chord towards the middle of the bracket. The maximum is then between
    // this position and the nearer end of the bracket, so the bracket becomes much shorter.
    const V pushed = choose(chord < middle, least(chord + beyond, middle), most(chord - beyond, middle));
    const V place = choose(at_first.smooth & at_last.smooth & ~slow, pushed, middle);
    const Slope<V> here = slope_at(place);
    const MarksOf<V> farther = here.value > none;
    first = choose(farther, place, first), last = choose(farther, last, place);
    at_first.value = choose(farther, here.value, at_first.value), at_last.value = choose(farther, at_last.value, here.value);
    at_first.smooth = choose(farther, here.smooth, at_first.smooth), at_last.smooth = choose(farther, at_last.smooth, here.smooth);
    if (step >= steady_steps) slow = (last - first) > half * width;
  }
  return {first, last, at_first, at_last};
}

template <class V>
KADR_IN_LANES V farthest_position(const V& place_first, const V& place_last, const Slope<V>& slope_first, const Slope<V>& slope_last,
                                  const MarksOf<V>& sought, float error, const auto& slope_at) {
  const Bracket<V> b = bracketed(place_first, place_last, slope_first, slope_last, sought, error, slope_at);
  return 0.5f * (b.first + b.last);
}

/// Searches the position of farthest reach as bracketed() does, for a slope that is smooth on the whole path. Then interpolates in the
/// final bracket, so the error of the result is much smaller than `error`.
template <class V>
KADR_IN_LANES V smooth_farthest_position(const V& place_first, const V& place_last, const Slope<V>& slope_first, const Slope<V>& slope_last,
                                         const MarksOf<V>& sought, float error, const auto& slope_at) {
  const Bracket<V> b = bracketed(place_first, place_last, slope_first, slope_last, sought, error, slope_at);
  const V place = b.first + (b.last - b.first) * (b.at_first.value / (b.at_first.value - b.at_last.value));
  return choose(sought, within(place, b.first, b.last), b.first);
}

}  // namespace kadr::lanes
