#pragma once
// The distance of a point from a straight edge, in the half plane of a turned part.

#include <algorithm>

#include "base/vec.h"

namespace kadr {

/// Returns the distance of `p` from the edge between `a` and `b`, mm.
inline double distance_to_edge(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double square = dot(d, d), part = square > 0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0;
  return length(a + part * d - p);
}

}  // namespace kadr
