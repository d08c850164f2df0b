#pragma once
// Computes the distance of the origin from a triangle. A caller gives the corners relative to the point whose distance is needed.

#include <algorithm>

#include "base/matrix.h"

namespace kadr {

inline double square_of(const Vec3& v) { return v.x * v.x + v.y * v.y + v.z * v.z; }

/// Returns the squared distance in mm² of the origin from the segment between `from` and `from + delta`.
inline double square_to_segment(const Vec3& from, const Vec3& delta) {
  const double length_squared = square_of(delta);
  const double share = length_squared > 0 ? std::clamp(-dot(from, delta) / length_squared, 0.0, 1.0) : 0;
  return square_of(from + share * delta);
}

/// Returns the squared distance in mm² of the origin from a triangle: the distance from the triangle's plane if the origin projects into
/// the triangle, else the distance from the nearest side of the triangle.
inline double square_to_triangle(const Vec3 (&corner)[3]) {
  Vec3 side[3];
  for (int k = 0; k < 3; ++k) side[k] = corner[(k + 1) % 3] - corner[k];
  const Vec3 normal = cross(side[0], side[1]);
  const double size = square_of(normal);
  if (size > 0) {
    bool over = true;
    for (int k = 0; k < 3 && over; ++k) over = dot(cross(corner[k], corner[(k + 1) % 3]), normal) >= 0;
    const double off = dot(corner[0], normal);
    if (over) return off * off / size;
  }
  double least = square_to_segment(corner[0], side[0]);
  for (int k = 1; k < 3; ++k) least = std::min(least, square_to_segment(corner[k], side[k]));
  return least;
}

}  // namespace kadr
