#pragma once
// The place on the way at which a tool's rounded or conical end leaves a line farthest. For stock/cut/level_rows and upright_rows.
//
// A straight line and a convex body that moves along a straight way: how far the body reaches on the line is concave along the way, so that
// one place is the farthest, and the sign of a slope tells on which side of any place it lies. Most lines are decided by the slopes at both
// ends of the way. Where not, the chord through the slopes proposes the next place; the middle does where the line misses the body at an
// end, or when a chord has not halved what was left.

#include "stock/cut/lanes.h"

namespace kadr::lanes {

/// At one place of the way.
template <class V>
struct Slope {
  V value;            // above 0: farther on is better
  MarksOf<V> smooth;  // the line meets the body: the slope changes steadily
};

inline constexpr int steady_steps = 2, most_steps = 48;

/// Where the farthest place lies between.
template <class V>
struct Bracket {
  V first, last;
  Slope<V> at_first, at_last;
};

/// `slope_at(place)` gives the Slope. At `first` it is above 0, at `last` below 0 in the `sought` lanes; others are of no account.
template <class V>
KADR_IN_LANES Bracket<V> bracketed(const V& way_first, const V& way_last, const Slope<V>& slope_first, const Slope<V>& slope_last,
                                   const MarksOf<V>& sought, float error, const auto& slope_at) {
  V first = way_first, last = way_last;
  Slope<V> at_first = slope_first, at_last = slope_last;
  const V half = spread<V>(0.5f), none = spread<V>(0.f), beyond = spread<V>(0.5f * error);
  MarksOf<V> slow = sought & ~sought;
  for (int step = 0; step < most_steps; ++step) {
    const V width = last - first, middle = half * (first + last);
    if (!any(sought & (width > error))) break;
    const V chord = within(first + width * (at_first.value / (at_first.value - at_last.value)), first, last);
    // Somewhat nearer to the middle, so that the place that is sought comes to lie between this one and the near end.
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
KADR_IN_LANES V farthest_place(const V& way_first, const V& way_last, const Slope<V>& slope_first, const Slope<V>& slope_last,
                               const MarksOf<V>& sought, float error, const auto& slope_at) {
  const Bracket<V> b = bracketed(way_first, way_last, slope_first, slope_last, sought, error, slope_at);
  return 0.5f * (b.first + b.last);
}

/// The same where the slope is smooth everywhere: by the chord through the last two, far nearer than `error`.
template <class V>
KADR_IN_LANES V smooth_farthest_place(const V& way_first, const V& way_last, const Slope<V>& slope_first, const Slope<V>& slope_last,
                                      const MarksOf<V>& sought, float error, const auto& slope_at) {
  const Bracket<V> b = bracketed(way_first, way_last, slope_first, slope_last, sought, error, slope_at);
  const V place = b.first + (b.last - b.first) * (b.at_first.value / (b.at_first.value - b.at_last.value));
  return choose(sought, within(place, b.first, b.last), b.first);
}

}  // namespace kadr::lanes
