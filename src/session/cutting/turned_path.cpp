// Converts positions in space to positions in a half plane that begins at the axis of rotation of the part. This file is used by
// session/cutting.

#include "session/cutting/turned_path.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr double in_plane = 1e-6;  // mm; a path that leaves the plane by less counts as a path in the plane
constexpr int max_parts = 1000;    // greatest number of segments into which a path past the axis is divided

Vec2 flat(Vec3 v) { return {v.x, v.y}; }

/// Returns the number of chords that approximate a straight path past the axis of rotation. The radius along the path is a hyperbola. The
/// sagitta of a chord is length² / (8 · nearest radius).
int parts_of(Vec2 from, Vec2 to, double chord) {
  const Vec2 delta = to - from;
  const double far = length(delta), nearest = far > 0 ? std::fabs(cross(from, to)) / far : 0;
  return int(std::clamp(std::ceil(far / std::sqrt(8 * chord * std::max(nearest, in_plane))), 1.0, double(max_parts)));
}

}  // namespace

Vec2 radius_axis(const std::vector<PathSegment>& pieces, Vec3 zero) {
  double x = 0, y = 0;
  for (const PathSegment& p : pieces)
    for (const Vec3& at : {p.from - zero, p.to - zero}) x = std::max(x, std::fabs(at.x)), y = std::max(y, std::fabs(at.y));
  return y > x ? Vec2{0, 1} : Vec2{1, 0};
}

void each_turned(const PathSegment& piece, Vec3 zero, Vec2 axis, double chord, const std::function<void(Vec3 from, Vec3 to)>& visit) {
  const Vec3 from = piece.from - zero, to = piece.to - zero;
  const double first = dot(flat(from), axis), last = dot(flat(to), axis);
  if (std::fabs(cross(axis, flat(from))) < in_plane && std::fabs(cross(axis, flat(to))) < in_plane)
    return visit({first, 0, from.z}, {last, 0, to.z});
  const double side = std::copysign(1.0, std::fabs(first) > std::fabs(last) ? first : last);
  const int count = parts_of(flat(from), flat(to), chord);
  const auto at = [&](int part) {
    const Vec3 place = part == count ? to : from + (double(part) / count) * (to - from);
    return Vec3{side * length(flat(place)), 0, place.z};
  };
  for (int i = 0; i < count; ++i) visit(at(i), at(i + 1));
}

}  // namespace kadr
