#pragma once
// Marks the lattice lines, among eight, over which the surface of a tilted tool turns (tilted_over.h). Used by stock/cut/tilted_cutter.

#include "stock/cut/tilted_over.h"
#include "stock/cut/tilted_pose.h"

namespace kadr::lanes {

/// Converts a number with one bit per lane into lane marks.
template <class V>
KADR_IN_LANES MarksOf<V> marks_of(unsigned bits) {
  alignas(32) std::int32_t each[lane_count];
  for (int i = 0; i < lane_count; ++i) each[i] = (bits >> i & 1) != 0 ? -1 : 0;
  return lanes_at<MarksOf<V>>(each);
}

/// A lattice line in the tool's coordinates, in the pose at one end of the path.
template <class V>
struct LineAtEnd {
  Vec3Of<V> at;
  Heading heading;
};

/// Marks lines that have an interval in both end poses (`first`, `last`), with a gap of more than `apart` mm between the two intervals. A
/// line whose interval `sought` extends only a little into this gap is not marked, because the error is then at most turn · (length in the
/// gap).
template <class V>
KADR_IN_LANES MarksOf<V> are_apart(const Swept<V>& first, const Swept<V>& last, const Swept<V>& sought, float apart) {
  const V from = least(first.to, last.to), to = most(first.from, last.from);
  return (first.from <= first.to) & (last.from <= last.to) & (to - from > apart) & (sought.from <= sought.to) &
         (least(sought.to - from, to - sought.from) > 0.25f * apart);
}

/// Marks lines of which more than `apart` mm of the interval `sought` are outside the intervals in the end poses, and lines that
/// are_apart() marks. The curvature of a cone grows towards the apex, so a gap may appear and vanish between the end poses.
template <class V>
KADR_IN_LANES MarksOf<V> are_far_from(const Swept<V>& first, const Swept<V>& last, const Swept<V>& sought, float apart) {
  const V from = least(first.from, last.from), to = most(first.to, last.to);
  const MarksOf<V> before = least(from, sought.to) - sought.from > apart, after = sought.to - most(to, sought.from) > apart;
  return (sought.from <= sought.to) & (before | after | are_apart(first, last, sought, apart));
}

template <class V>
KADR_IN_LANES Swept<V> in_cone_and_shaft(const LineAtEnd<V>& line, const TiltedBody& body) {
  const Swept<V> in = in_frustum<V, Side::any>(line.at, line.heading, body.end), cone = where(in.from <= in.to, in.from, in.to);
  return body.shaft.high > body.shaft.low ? either(cone, in_frustum<V, Side::straight>(line.at, line.heading, body.shaft)) : cone;
}

/// Returns the intervals of the lines inside a bull-nose body in one pose.
template <class V>
KADR_IN_LANES Swept<V> in_rounded(const LineAtEnd<V>& line, const TiltedBody& body) {
  const V none = spread<V>(0.f);
  const TiltedLines<V> lines{line.heading, line.heading, line.heading, path_past<V>({none, none, none})};
  return in_shifted_rounded(lines, body, {line.at, line.at, line.at});
}

template <class V, TiltedBody::Kind kind>
KADR_IN_LANES MarksOf<V> are_turned_over(const TiltedOver& over, int family, const TiltedBody& body, const LineAtEnd<V>& first,
                                         const LineAtEnd<V>& last, const Swept<V>& sought) {
  const TiltedOver::Family& by = over.family[family];
  MarksOf<V> turned = sought.from < sought.to;
  if (!any(turned)) return turned;
  turned = turned & ~turned;
  // The side of the shaft counts as unlimited in height. If a line meets this unlimited side above or below the body in an end pose, it
  // meets the body itself at another position on the path.
  if (by.by_shaft) {
    const float radius = body.shaft.low_radius;
    const auto in = [&](const LineAtEnd<V>& l) { return in_circle(l.at.x, l.at.y, l.heading, radius); };
    turned = are_apart(in(first), in(last), sought, over.apart);
  }
  if constexpr (kind == TiltedBody::Kind::cone) {
    if (by.by_end) turned = turned | are_far_from(in_cone_and_shaft(first, body), in_cone_and_shaft(last, body), sought, over.apart);
  }
  if constexpr (kind == TiltedBody::Kind::rounded) {
    if (by.by_edge) turned = turned | are_apart(in_rounded(first, body), in_rounded(last, body), sought, over.apart);
  }
  return turned;
}

}  // namespace kadr::lanes
