#pragma once
// A cylinder of a tilted tool at both ends of its path, and whether it reaches farther on a line in between.
//
// For a convex body that shifts, the pairs (position on the line, position on the path) at which it contains the line's point form a
// convex set: the position where the line enters the body is a convex function of the path. So if, at an end of the path, that
// position moves out of the face or side on which it lies, the body reaches farthest right there. If the line nearly lies in that
// face, a turn may upset this: then nothing is decided here.

#include "stock/cut/lean_rows.h"

namespace kadr::lanes {

/// The lines of a family, in the tool's coordinates at the middle of the path.
template <class V>
struct LeanFamily {
  LeanLines<V> even;    // with the shift of the brick's middle
  Heading first, last;  // at the ends of the path
  /// Signed distance of a line from the tool's axis times the sine of the angle between them: for the brick's middle, per mm of lane,
  /// and per mm of row; `reach` bounds it for lines that come near.
  float aside, aside_lane, aside_row, reach;
};
/// Eight lines of a family.
template <class V>
struct LeanRow {
  Vec3Of<V> at, shift;    // of the lines' middles; `at` is corrected to halfway between the chord and the true curve
  Vec3Of<V> first, last;  // their positions at the ends of the path
  Swept<V> at_ends;       // intervals inside the tool in the poses there
};

template <class V>
struct Pose {
  Vec3Of<V> at;  // middle of a line
  Heading heading;
  Swept<V> side, in;  // interval inside the endless side alone; inside the cylinder
};

template <class V>
KADR_IN_LANES Pose<V> in_pose(const Vec3Of<V>& at, const Heading& h, const Frustum& f) {
  const Swept<V> side = in_circle(at.x, at.y, h, f.low_radius);
  Swept<V> in = side;
  clip_by_faces(in, at.z, h, f);
  return {at, h, side, in};
}

/// The motion of a line's points past the tool.
template <class V>
struct PastTool {
  Vec3Of<V> shift, grows;  // of the line's middle; change per mm of line
  float radius;            // of the cylinder
  float steep;             // sine of the angle to a face or side above which a turn does not matter
  float bend;              // mm by which the points' paths may deviate from straight
};

/// Marks lines whose entry or exit point moves out of the cylinder. `by_face`: the point is on a flat face, the upper one if
/// `face_is_upper`.
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

/// Marks lines on which the cylinder reaches farthest, backwards or forwards, at one end of its path.
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
