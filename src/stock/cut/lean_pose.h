#pragma once
// A cylinder of a tool that leans as it stands at one end of its way, and whether it reaches farther on a line anywhere else on the way.
//
// Of a convex body that shifts, the places (on the line, on the way) at which it holds the line are a convex set: where the line enters it
// is a convex function of the way. So if the place where it enters moves out of the face or the side on which it lies there, the body
// reaches it farthest there and then. Where the line all but lies in that face a turn may turn this over: there nothing is told.

#include "stock/cut/lean_rows.h"

namespace kadr::lanes {

template <class V>
struct InPose {
  Swept<V> in;
  MarksOf<V> from_is_first, to_is_last;  // of all of the way
};

/// How the places of a line move past the tool on the way from the end at hand to the other.
template <class V>
struct PastTool {
  Vec3Of<V> shift, grows;  // of the line's middle; for each mm of line
  float steep;             // sine of the angle to a face or a side from which on a turn does not count
};

/// At the place of one end; `of_face`: the way out of a flat face, along the axis.
template <class V>
KADR_IN_LANES MarksOf<V> moves_out(const Vec3Of<V>& at, const Vec3Of<V>& e, const V& place, const PastTool<V>& past, float radius,
                                   const MarksOf<V>& by_face, const MarksOf<V>& face_is_up) {
  const Vec3Of<V> shift = plus(past.shift, place, past.grows);
  const V x = at.x + place * e.x, y = at.y + place * e.y, through = x * e.x + y * e.y;
  const MarksOf<V> side = (x * shift.x + y * shift.y >= 0.f) & (most(through, -through) >= past.steep * radius);
  const MarksOf<V> face = (choose(face_is_up, shift.z, -shift.z) >= 0.f) & (most(e.z, -e.z) >= past.steep);
  return choose(by_face, face, side);
}

template <class V>
KADR_IN_LANES InPose<V> in_pose(const Vec3Of<V>& at, const Vec3Of<V>& e, const Slant<V>& rise, const Frustum& f, const PastTool<V>& past) {
  const Swept<V> side = in_circle(at.x, at.y, e.x, e.y, e.x * e.x + e.y * e.y, spread<V>(f.low_radius));
  const V low = (f.low - at.z) * rise.per, high = (f.high - at.z) * rise.per;
  const Swept<V> in{most(side.from, least(low, high)), least(side.to, most(low, high))};
  const MarksOf<V> meets = in.from <= in.to, rises = e.z > 0.f;
  return {in, meets & moves_out(at, e, in.from, past, f.low_radius, in.from > side.from, ~rises),
          meets & moves_out(at, e, in.to, past, f.low_radius, in.to < side.to, rises)};
}

/// At both ends of the way together.
template <class V>
KADR_IN_LANES InPose<V> in_poses(const LeanLines<V>& l, const Vec3Of<V>& first, const Vec3Of<V>& last, const Frustum& f,
                                 const PastTool<V>& past) {
  const PastTool<V> back{{-past.shift.x, -past.shift.y, -past.shift.z}, {-past.grows.x, -past.grows.y, -past.grows.z}, past.steep};
  const InPose<V> a = in_pose(first, l.first_direction, l.first_rise, f, past), b = in_pose(last, l.last_direction, l.last_rise, f, back);
  return {either(where(a.in.from <= a.in.to, a.in.from, a.in.to), b.in), a.from_is_first | b.from_is_first, a.to_is_last | b.to_is_last};
}

}  // namespace kadr::lanes
