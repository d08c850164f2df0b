#pragma once
// A cylinder of a tool that leans as it stands at both ends of its way, and whether it reaches farther on a line in between.
//
// Of a convex body that shifts, the places (on the line, on the way) at which it holds the line are a convex set: where the line enters it
// is a convex function of the way. So if the place where it enters moves out of the face or the side on which it lies there, the body
// reaches it farthest there and then. Where the line all but lies in that face a turn may turn this over: there nothing is told.

#include "stock/cut/lean_rows.h"

namespace kadr::lanes {

/// The lines of a family, seen from the tool in the middle of its way.
template <class V>
struct LeanFamily {
  LeanLines<V> even;    // as it shifts in the middle of the brick
  Heading first, last;  // as they are at the ends of the way
  /// How far a line goes past the tool's axis, to one side of it, times the sine of the angle between them: of the brick's middle, for each
  /// mm of lane and of row; `reach`: of lines that come near.
  float aside, aside_lane, aside_row, reach;
};
/// Eight of them.
template <class V>
struct LeanRow {
  Vec3Of<V> at, shift;    // of their middles, between the ends of the way as far from its chord as from where they bend to
  Vec3Of<V> first, last;  // where these are at the ends of the way
  Swept<V> at_ends;       // by the tool as it stands there
};

template <class V>
struct Pose {
  Vec3Of<V> at;  // of a line
  Heading heading;
  Swept<V> side, in;  // by the side alone, were it endless; by the cylinder
};

template <class V>
KADR_IN_LANES Pose<V> in_pose(const Vec3Of<V>& at, const Heading& h, const Frustum& f) {
  const Swept<V> side = in_circle(at.x, at.y, h, f.low_radius);
  Swept<V> in = side;
  clip_by_faces(in, at.z, h, f);
  return {at, h, side, in};
}

/// How the places of a line move past the tool on its way.
template <class V>
struct PastTool {
  Vec3Of<V> shift, grows;  // of the line's middle; for each mm of line
  float radius;            // of the cylinder
  float steep;             // sine of the angle to a face or a side from which on a turn does not count
  float bend;              // mm by which their way may not be straight
};

/// The place where a line enters or leaves the cylinder moves out of it; `by_face`: it lies in a flat face, which is the upper one or not.
template <class V>
KADR_IN_LANES MarksOf<V> moves_out(const Pose<V>& pose, const V& place, const PastTool<V>& past, float forth, const MarksOf<V>& by_face,
                                   bool face_is_upper) {
  const Heading& e = pose.heading;
  const V up = forth * (past.shift.z + place * past.grows.z);
  const V x = pose.at.x + place * e.x, y = pose.at.y + place * e.y, through = x * e.x + y * e.y;
  const V beside = forth * (x * (past.shift.x + place * past.grows.x) + y * (past.shift.y + place * past.grows.y));
  const MarksOf<V> side = (beside >= past.bend * past.radius) & (most(through, -through) >= past.steep * past.radius);
  const MarksOf<V> face = (face_is_upper ? up : -up) >= (std::fabs(e.z) >= past.steep ? past.bend : missed);
  return choose(by_face, face, side);
}

/// Where the cylinder reaches farthest at one end of its way, backwards on the line or onwards.
template <class V>
KADR_IN_LANES MarksOf<V> is_farthest_back(const Pose<V>& first, const Pose<V>& last, const PastTool<V>& past) {
  const auto at = [&](const Pose<V>& p, float forth) {
    return (p.in.from <= p.in.to) & moves_out(p, p.in.from, past, forth, p.in.from > p.side.from, p.heading.z < 0.f);
  };
  return at(first, 1.f) | at(last, -1.f);
}
template <class V>
KADR_IN_LANES MarksOf<V> is_farthest_on(const Pose<V>& first, const Pose<V>& last, const PastTool<V>& past) {
  const auto at = [&](const Pose<V>& p, float forth) {
    return (p.in.from <= p.in.to) & moves_out(p, p.in.to, past, forth, p.in.to<p.side.to, p.heading.z> 0.f);
  };
  return at(first, 1.f) | at(last, -1.f);
}

}  // namespace kadr::lanes
