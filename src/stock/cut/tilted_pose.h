#pragma once
// Intersects lattice lines with a cylinder of a tilted tool in the poses at both ends of its path, and finds whether the cylinder reaches
// farther along a line between these poses.
//
// Let a convex body shift without turning. The pairs (position on the line, position on the path) for which the body contains the point of
// the line then form a convex set. So the position at which the line enters the body is a convex function of the position on the path. If,
// in an end pose, this entry point moves out of the face or side that contains it, the body reaches farthest in this end pose. A turn of
// the body may change this result if the line nearly lies in the face or side: such lines are left undecided here.

#include "stock/cut/tilted_rows.h"

namespace kadr::lanes {

/// The lines of a family, in the tool's coordinates in the pose half way along the path.
template <class V>
struct TiltedFamily {
  TiltedLines<V> even;  // The lines, as if all points of the brick moved past the tool like the middle of the brick.
  Heading first, last;  // direction of the lines in the poses at the start and the end of the path
  /// The product of two numbers: the signed distance of a line from the tool's axis, and the sine of the angle between the line and the
  /// axis. `aside` is the product for the line through the brick's middle; aside_lane and aside_row are its change per mm across the lines.
  /// For lines that come near the tool, the absolute value of the product is at most `reach`.
  float aside, aside_lane, aside_row, reach;
};
/// Eight lattice lines of a family, and their intervals in the end poses.
template <class V>
struct TiltedRow {
  // `at`: the middle points of the lines half way along the path, half way between their true curve and its chord; `shift`: the motion of
  // these points past the tool.
  Vec3Of<V> at, shift;
  Vec3Of<V> first, last;  // middle points of the lines in the end poses
  Swept<V> at_ends;       // intervals of the lines inside the tool in the end poses
};

template <class V>
struct Pose {
  Vec3Of<V> at;  // middle point of each lattice line
  Heading heading;
  // side: interval of the line inside the cylinder if its height were unlimited; in: interval inside the cylinder itself.
  Swept<V> side, in;
};

template <class V>
KADR_IN_LANES Pose<V> in_pose(const Vec3Of<V>& at, const Heading& h, const Frustum& f) {
  const Swept<V> side = in_circle(at.x, at.y, h, f.low_radius);
  Swept<V> in = side;
  clip_by_faces(in, at.z, h, f);
  return {at, h, side, in};
}

/// The motion of the points of a line past the tool.
template <class V>
struct PastTool {
  Vec3Of<V> shift, grows;  // shift of the line's middle point, and the change of this shift per mm along the line
  float radius;            // radius of the cylinder, mm
  float steep;  // Sine of an angle: if a line meets a face or the side at a greater angle, the turn of the tool has no influence.
  float bend;   // distance in mm by which the paths of the points may deviate from straight lines
};

/// Marks lines whose entry or exit point at `place` is moving out of the cylinder, as the tool moves along its path (`forth` 1) or back
/// (`forth` -1). In the lanes of `by_face` the point is on a flat face (the upper face if `face_is_upper`), in the other lanes on the side.
template <class V>
KADR_IN_LANES MarksOf<V> moves_out(const Pose<V>& pose, const V& place, const PastTool<V>& past, float forth, const MarksOf<V>& by_face,
                                   bool face_is_upper) {
  const Heading& e = pose.heading;
  const V up = forth * (past.shift.z + place * past.grows.z);
  const V x = pose.at.x + place * e.x, y = pose.at.y + place * e.y, through = x * e.x + y * e.y;
  const V aside = forth * (x * (past.shift.x + place * past.grows.x) + y * (past.shift.y + place * past.grows.y));
  const MarksOf<V> side = (aside >= past.bend * past.radius) & (most(through, -through) >= past.steep * past.radius);
  const MarksOf<V> face = (face_is_upper ? up : -up) >= (std::fabs(e.z) >= past.steep ? past.bend : missed);
  return choose(by_face, face, side);
}

/// Marks lines on which the cylinder reaches farthest, in the negative direction of the line, in one of the end poses. is_farthest_on()
/// does the same for the positive direction.
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
