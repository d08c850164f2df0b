#pragma once
// Finds the intervals of lattice lines along X or Y inside the volume that a body of an upright tool sweeps along a straight path. Numbers
// have single precision; lengths are in mm from the brick's corner.
//
//   law  a point in an interval is inside the body at some position on the path, to within 2e-4 mm (tests/stock/sweep_test)

#include "stock/cut/upright_rows.h"

namespace kadr::lanes {

/// The path of the tool, with components along and across the lattice lines of one axis.
struct LevelPath {
  LevelPath(const LocalSweep& s, int axis)
      : start(s.from[axis]), across_start(s.from[1 - axis]), forth(s.direction[axis]), across(s.direction[1 - axis]), up(s.direction[2]) {
    const float guarded = std::fabs(across) < 1e-9f ? 1e-9f : across;
    per_across = 1 / guarded;
    side = s.flat_direction[axis] * s.per_flat * (guarded > 0.f ? 1.f : -1.f);
  }
  float start, across_start;  // position of the tip at the start of the path, mm: along the lines and across the lines
  float forth, across, up;    // unit vector of the path
  float per_across;
  // A disc of the tool reaches farthest along a lattice line at one position on the path. `side` describes this position: the signed
  // distance, across the lines, of the disc's centre from the line, divided by the disc's radius.
  float side;
};

/// Positions of lattice lines relative to the tip at the start of the path: the distance across the lines, and the height above the tip,
/// mm.
template <class V>
struct LevelLines {
  V across, up;
};

/// The section of the path on which a given range of heights of the tool passes the height of a lattice line.
template <class V>
struct PathSection {
  V first, last;
  MarksOf<V> any;
};
template <class V>
KADR_IN_LANES PathSection<V> at_height(const LocalSweep& s, const V& up, float low, float high) {
  const V a = (up - high) * s.per_upward, b = (up - low) * s.per_upward;
  const V first = most(least(a, b), spread<V>(0.f)), last = least(most(a, b), spread<V>(s.length));
  return {first, last, (up >= std::min(s.rise, 0.f) + low) & (up <= std::max(s.rise, 0.f) + high) & (first <= last)};
}

/// A position on the path in mm, and the square of half the length of the lattice line inside the tool at this position.
template <class V>
struct LeftAt {
  V place, square;
};
template <class V>
KADR_IN_LANES Swept<V> between(const LevelPath& w, const LeftAt<V>& from, const LeftAt<V>& to, const MarksOf<V>& on) {
  const MarksOf<V> meets = on & (least(from.square, to.square) >= 0.f);
  return where(meets, from.place * w.forth + w.start - root(from.square), to.place * w.forth + w.start + root(to.square));
}

/// Returns the intervals of lattice lines that a cylinder sweeps on a section of the path.
template <class V>
KADR_IN_LANES Swept<V> level_cylinder(const LevelPath& w, const LevelLines<V>& lines, const PathSection<V>& on, float radius) {
  const float edge = radius * w.side;
  const V square = spread<V>(radius * radius), to = within((lines.across + edge) * w.per_across, on.first, on.last),
          from = within((lines.across - edge) * w.per_across, on.first, on.last);
  const V to_side = to * w.across - lines.across, from_side = from * w.across - lines.across;
  return between(w, LeftAt<V>{from, square - from_side * from_side}, LeftAt<V>{to, square - to_side * to_side}, on.any);
}

/// Returns the intervals of lattice lines that the lower half of a ball sweeps.
template <class V>
KADR_IN_LANES Swept<V> level_ball(const LevelPath& w, const SweptBody& b, const LevelLines<V>& lines, const PathSection<V>& on) {
  float across = w.across, up = w.up,
        // Equals 1 - forth², but that formula would lose all digits if the path is nearly parallel to the lattice lines.
      square = across * across + up * up;
  const bool along = square < upright_below * upright_below;
  if (along) across = up = 0.f, square = upright_below * upright_below;
  const float per_square = 1 / square, slope = w.forth / std::sqrt(square);
  const V above = lines.up - b.end_top, aside = lines.across * up - above * across;
  const V nearest = (lines.across * across + above * up) * per_square;
  const V apart = along ? lines.across * lines.across + above * above : aside * aside * per_square;
  const V room = spread<V>(b.radius * b.radius) - apart, reach = root(room) * slope;
  const V to = within(nearest + reach, on.first, on.last), from = within(nearest - reach, on.first, on.last);
  const V to_far = to - nearest, from_far = from - nearest;
  return between(w, LeftAt<V>{from, room - from_far * from_far * square}, LeftAt<V>{to, room - to_far * to_far * square}, on.any);
}

/// The intersection of a lattice line with the end of a tool (a cone or a corner radius), at one position on the path.
template <class V>
struct EndAt {
  V square;  // square of half the length of the line inside the end of the tool, mm²
  // First summand of a slope, without its sign: the point where the lattice line leaves the end of the tool moves along the line with a
  // slope proportional to sign · forth + turn, while the tool moves along its path.
  V forth;
  V turn;  // second summand of the slope that `forth` describes
};
template <class V, BodyEnd end>
KADR_IN_LANES EndAt<V> end_at(const LevelPath& w, const SweptBody& b, const LevelLines<V>& lines, const V& place) {
  const V none = spread<V>(0.f), height = within(lines.up - place * w.up - b.bottom, none, spread<V>(b.tall()));
  const V side = place * w.across - lines.across;
  V radius, grows, scale;  // The quotient grows / scale is the change of the tool's radius in mm per mm of height.
  if constexpr (end == BodyEnd::cone) {
    radius = height * b.widens + b.flat, grows = spread<V>(b.widens), scale = spread<V>(1.f);
  } else {
    scale = root(height * (2 * b.corner - height)), radius = scale + b.flat, grows = spread<V>(b.corner) - height;
  }
  // At positions on the path where the end of the tool misses the line, the result is a slope whose sign points towards the positions at
  // which the end of the tool meets the line.
  const V square = (radius - side) * (radius + side), towards = choose(side > 0.f, spread<V>(w.across), spread<V>(-w.across));
  const V rises = grows * w.up;
  const MarksOf<V> meets = square > 0.f;
  return {square, choose(meets, root(square) * scale * w.forth, none),
          choose(meets, -(rises * radius + side * scale * w.across), -(rises + scale * towards))};
}

/// Finds the position on the path at which the end of the tool reaches farthest along the line, in the direction `sign` (1 or -1).
template <class V, BodyEnd end>
KADR_IN_LANES LeftAt<V> farthest(const LevelPath& w, const SweptBody& b, const LevelLines<V>& lines, const PathSection<V>& on, float sign,
                                 const EndAt<V>& first, const EndAt<V>& last) {
  const auto slope_of = [&](const EndAt<V>& e) { return Slope<V>{e.forth * sign + e.turn, e.square > 0.f}; };
  const Slope<V> at_first = slope_of(first), at_last = slope_of(last);
  const MarksOf<V> begins = at_first.value <= 0.f, ends = ~begins & (at_last.value >= 0.f), sought = on.any & ~begins & ~ends;
  LeftAt<V> answer{choose(begins, on.first, on.last), choose(begins, first.square, last.square)};
  if (!any(sought)) return answer;
  const auto slope_at = [&](const V& place) { return slope_of(end_at<V, end>(w, b, lines, place)); };
  const V place = farthest_position(on.first, on.last, at_first, at_last, sought, b.error_at_position, slope_at);
  const EndAt<V> there = end_at<V, end>(w, b, lines, place);
  return {choose(sought, place, answer.place), choose(sought, there.square, answer.square)};
}

template <class V, BodyEnd end>
KADR_IN_LANES Swept<V> level_end(const LevelPath& w, const SweptBody& b, const LevelLines<V>& lines, const PathSection<V>& on) {
  if constexpr (end == BodyEnd::ball) {
    return level_ball(w, b, lines, on);
  } else {
    const EndAt<V> first = end_at<V, end>(w, b, lines, on.first), last = end_at<V, end>(w, b, lines, on.last);
    return between(w, farthest<V, end>(w, b, lines, on, -1.f, first, last), farthest<V, end>(w, b, lines, on, 1.f, first, last), on.any);
  }
}

/// Returns the intervals of lattice lines that the body sweeps; the lines are at the positions `across`, `z`. The body is convex, so its
/// end and its cylinder together sweep one interval of a line.
template <class V, BodyEnd end>
KADR_IN_LANES Swept<V> level_lines(const LocalSweep& s, const LevelPath& w, const SweptBody& b, const V& across, const V& z) {
  const LevelLines<V> lines{across - w.across_start, z - s.from[2]};
  Swept<V> swept{spread<V>(missed), spread<V>(-missed)};
  if constexpr (end != BodyEnd::flat) {
    const PathSection<V> on = at_height(s, lines.up, b.bottom, b.end_top);
    if (any(on.any)) swept = level_end<V, end>(w, b, lines, on);
  }
  if (b.top <= b.end_top) return swept;
  const PathSection<V> on = at_height(s, lines.up, b.end_top, b.top);
  if (!any(on.any)) return swept;
  const Swept<V> cylinder = level_cylinder(w, lines, on, b.radius);
  return {least(swept.from, cylinder.from), most(swept.to, cylinder.to)};
}

}  // namespace kadr::lanes
