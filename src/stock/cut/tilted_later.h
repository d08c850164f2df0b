#pragma once
// Part of TiltedCutter: finds the lines for which the computed interval may be wrong. TiltedCutter does not cut these lines; the caller
// cuts them with the two halves of the path. Only stock/cut/tilted_cut includes this file.

#include "stock/cut/tilted_cutter.h"

namespace kadr {

/// Marks the lines for which an end of the swept interval is certain. Two conditions must be met: `end` is also an end of the interval
/// inside the cylinder in the given pose (at the start or the end of the path), and the line crosses the cylinder's surface at this point
/// at an angle much greater than the tool's turn.
///   half   half the edge length of the brick in mm, because the positions in poses are relative to the brick's middle
///   steep  sine of the least angle that is steep enough
template <class V>
KADR_IN_LANES MarksOf<V> meets_steeply(const Pose<V>& pose, const V& end, bool is_from, float half, float radius, float steep) {
  const Heading& e = pose.heading;
  const V place = is_from ? pose.in.from : pose.in.to, at_side = is_from ? pose.side.from : pose.side.to, found = place + half;
  const V x = pose.at.x + place * e.x, y = pose.at.y + place * e.y, through = x * e.x + y * e.y;
  const MarksOf<V> by_side = is_from ? place <= at_side : place >= at_side;
  const V sine = choose(by_side, most(through, -through), spread<V>(std::fabs(e.z) * radius));
  return (pose.in.from <= pose.in.to) & (found <= end) & (found >= end) & (sine >= steep * radius);
}

/// Marks positions at which the surface of a bull-nose tool may be nearly parallel to the line: positions close to the tool's lower face,
/// or on its side.
template <class V>
KADR_IN_LANES MarksOf<V> TiltedCutter::is_where_flat(const TiltedFamily<V>& all, const TiltedRow<V>& line, int family,
                                                     const V& place) const {
  const TiltedBody& b = tilted_body_;
  const V at = place - half_, first = line.first.z + at * all.first.z, last = line.last.z + at * all.last.z;
  const TiltedOver::Family& by = over_.family[family];
  return (least(first, last) < (by.by_edge || by.by_face ? over_.edge_below : -missed)) |
         (most(first, last) > (by.by_shaft  ? b.middle - 0.1f * b.corner
                               : by.by_face ? b.shaft.high - 0.1f
                                            : missed));
}

/// Marks lines of which the tool may sweep more than the computed interval. Each end of the interval was computed with the shift that
/// belongs to this end; for a position x mm farther out, the true shift differs by x · turn / 2. A second intersection, with a slightly
/// larger body, shows the angle between the surface and the line. If the surface is steeper than the shift can change, the tool cannot
/// reach a position farther out, and the line is not marked.
template <class V, TiltedBody::Kind kind>
KADR_IN_LANES MarksOf<V> TiltedCutter::may_reach_farther(const TiltedFamily<V>& all, int family, const TiltedRow<V>& line,
                                                         const Swept<V>& swept, const Swept<V>& material) const {
  const float most_off = over_.apart / 2;
  const TiltedBody hardly_larger = tilted_body_.larger(over_allowed);
  const MarksOf<V> there = material.from < material.to;
  MarksOf<V> misses = there & (swept.from > swept.to);
  MarksOf<V> open_from = there & ~misses & (swept.from - material.from > most_off) & (swept.from < material.to),
             open_to = there & ~misses & (material.to - swept.to > most_off) & (swept.to > material.from);
  if constexpr (kind == TiltedBody::Kind::cylinder) {
    if (any(open_from | open_to)) {
      const Frustum& f = tilted_body_.shaft;
      const Pose<V> first = in_pose(line.first, all.first, f), last = in_pose(line.last, all.last, f);
      const auto is_steep = [&](const Pose<V>& pose, const V& end, bool is_from) {
        return meets_steeply(pose, end, is_from, half_, f.low_radius, 4 * tilted_sweep_.half_turn);
      };
      open_from = open_from & ~is_steep(first, swept.from, true) & ~is_steep(last, swept.from, true);
      open_to = open_to & ~is_steep(first, swept.to, false) & ~is_steep(last, swept.to, false);
    }
  }
  if constexpr (kind == TiltedBody::Kind::rounded) {
    open_from = open_from & is_where_flat(all, line, family, swept.from), open_to = open_to & is_where_flat(all, line, family, swept.to);
  }
  const Vec3Of<V> grows = vector_of<V>(tilted_sweep_.shift_grows[family]);
  TiltedLines<V> lines{all.even.heading, all.first, all.last, all.even.past};
  const auto around_line = [&](const TiltedRow<V>& l) {
    const Swept<V> nearly = in_cylinder(l.at, all.even.heading, around_);
    return Swept<V>{nearly.from + half_, nearly.to + half_};
  };
  const auto with_shift_at = [&](const V& place) {
    const Vec3Of<V> here = plus(line.shift, place - half_, grows);
    lines.past = path_past<V>({-here.x, -here.y, -here.z});
    const TiltedPosition<V> at{plus(line.at, spread<V>(-0.5f), here), line.first, line.last};
    return either(tilted_swept<V, kind>(lines, hardly_larger, at, near_), shifted_at_ends<V, kind>(lines, hardly_larger, at.at));
  };
  MarksOf<V> farther = there & ~there;
  if (any(misses)) misses = misses & meet(around_line(line), material);
  if (any(misses)) {
    const Swept<V> even = tilted_swept<V, kind>(all.even, outer_, evenly_shifted_position(all.even, line.at), near_);
    farther = misses & meet(Swept<V>{even.from + half_, even.to + half_}, material) &
              (least(even.to, spread<V>(half_)) - most(even.from, spread<V>(-half_)) > most_off);
  }
  // If even the slightly larger body does not contain an end of the computed interval, the search for this end has failed, and the line is
  // marked.
  const auto look_at = [&](const MarksOf<V>& open, const V& end, bool is_from) {
    if (!any(open)) return;
    const Swept<V> larger = with_shift_at(end);
    const V place = end - half_, on = is_from ? place - larger.from : larger.to - place;
    farther = farther | (open & ((on > most_off) | (place < larger.from) | (place > larger.to)));
  };
  look_at(open_from, swept.from, true);
  look_at(open_to, swept.to, false);
  return farther;
}

/// Records lines that TiltedCutter leaves uncut and that the caller must cut with the two halves of the path.
template <class V>
KADR_IN_LANES void TiltedCutter::leave_for_later(const MarksOf<V>& later, int family, int row, int lane) {
  alignas(32) std::int32_t each[lane_count];
  store(each, later);
  const int at = (row * brick_edge + lane) / LineSet::at_once;
  const unsigned asked_for = only_ == nullptr ? 255 : only_->bits[family][at];
  unsigned bits = 0;
  for (int i = 0; i < lane_count; ++i) bits |= each[i] != 0 ? 1u << i : 0;
  later_.bits[family][at] = std::uint8_t(later_.bits[family][at] | (bits & asked_for));
  later_.any = later_.any || later_.bits[family][at] != 0;
}

/// Returns and records the lines, among eight, that the caller must cut with the two halves of the path.
template <class V, TiltedBody::Kind kind>
KADR_OWN_FUNCTION MarksOf<V> TiltedCutter::for_later(const TiltedFamily<V>& all, int family, int row, int lane, const Swept<V>& swept,
                                                     const Swept<V>& material) {
  const V places = lanes_at<V>(scale_.place + lane) - half_;
  const float row_position = scale_.place[row] - half_;
  TiltedRow<V> line;
  line.at = line_value(tilted_sweep_.middle, tilted_sweep_.axes, family, places, row_position);
  line.shift = line_value(tilted_sweep_.shift, tilted_sweep_.shift_grows, family, places, row_position);
  line.first = plus(line.at, spread<V>(-0.5f), line.shift), line.last = plus(line.at, spread<V>(0.5f), line.shift);
  line.at = plus(line.at, spread<V>(0.5f), vector_of<V>(tilted_sweep_.aside));
  const Swept<V> asked = both(swept, material);
  const MarksOf<V> asks = asked.from < asked.to;
  MarksOf<V> nothing = asks & ~asks;
  if constexpr (kind == TiltedBody::Kind::rounded) {
    nothing = ~(is_where_flat(all, line, family, asked.from) | is_where_flat(all, line, family, asked.to));
  }
  const MarksOf<V> later = are_turned_over<V, kind>(over_, family, tilted_body_, {line.first, all.first}, {line.last, all.last},
                                                    where(~nothing, asked.from - half_, asked.to - half_)) |
                           may_reach_farther<V, kind>(all, family, line, swept, material);
  if (any(later)) leave_for_later<V>(later, family, row, lane);
  return later;
}

}  // namespace kadr
