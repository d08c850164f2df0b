#pragma once
// LocalSweep: a straight motion of a tool whose axis is parallel to Z, in the coordinates of one brick.

#include <algorithm>
#include <cmath>

#include "base/vec.h"
#include "stock/brick/lattice.h"

namespace kadr {

/// Distances in mm by which a body of the tool extends around the tip.
struct AroundTip {
  // Distances of the outermost points of the body from the tip; `below` is negative if the whole body is above the tip.
  double sideways, below, above;
};

/// A straight path of the tip. Lengths are in mm, from the brick's corner.
struct LocalSweep {
  float from[3];       // start of the path of the tip
  float direction[3];  // unit vector of the path; {1, 0, 0} if the tool does not move
  float length;
  float rise;               // Z component of the whole path in mm
  float per_upward;         // 1 / (Z component of `direction`); a large number for a level path
  float flat_direction[2];  // X and Y components of `direction`; both are 0 for a vertical path
  float flat, per_flat;     // Length of the vector flat_direction (0 to 1), and its inverse, which is finite even if the length is 0.
  bool upright;

  float lowest() const { return from[2] + std::min(rise, 0.f); }
  float highest() const { return from[2] + std::max(rise, 0.f); }
};

/// A path that is more than this many times longer than its section near the brick is shortened to that section, because single precision
/// has only seven digits.
inline constexpr double clipped_above = 4;
/// A path counts as vertical if the XY component of its unit vector is less than this limit: within a brick the error is less than 1e-4 mm.
inline constexpr float upright_below = 3e-6f;
inline constexpr float nearly_none = 1e-12f;

/// A section of a path, from the fraction `first` to the fraction `last` of its length (0 to 1).
struct PathPart {
  double first = 0, last = 1;
};

/// Returns the section of the path on which the tool can reach a box from {0, 0, 0} to `most`, with some margin; {0, 0} if the tool never
/// reaches the box.
inline PathPart part_that_reaches(Vec3 from, Vec3 direction, const AroundTip& tool, Vec3 most) {
  PathPart part;
  for (int d = 0; d < 3; ++d) {
    const double room = along(most, d) / 4, low = -(d == 2 ? tool.above : tool.sideways) - room,
                 high = along(most, d) + room + (d == 2 ? tool.below : tool.sideways);
    if (along(direction, d) == 0) continue;
    const double a = (low - along(from, d)) / along(direction, d), b = (high - along(from, d)) / along(direction, d);
    part.first = std::max(part.first, std::min(a, b)), part.last = std::min(part.last, std::max(a, b));
  }
  if (part.first > part.last) return {0, 0};
  return part;
}

/// Converts a path, whose positions are given from the brick's corner, to a LocalSweep. `edge` is the edge length of the brick, mm.
inline LocalSweep local_sweep(Vec3 from, Vec3 to, const AroundTip& tool, double edge) {
  Vec3 direction = to - from;
  const double whole_length = length(direction);
  double all = whole_length;
  LocalSweep s{};
  if (all > clipped_above * (edge + 2 * tool.sideways)) {
    const PathPart part = part_that_reaches(from, direction, tool, {edge, edge, edge});
    from = from + part.first * direction, all = all * (part.last - part.first);
  }
  const double per = all > 0 ? 1 / whole_length : 0;
  direction = all > 0 ? per * direction : Vec3{1, 0, 0};
  for (int d = 0; d < 3; ++d) s.from[d] = float(along(from, d)), s.direction[d] = float(along(direction, d));
  s.length = float(all), s.rise = float(all * direction.z);
  const float flat = std::sqrt(s.direction[0] * s.direction[0] + s.direction[1] * s.direction[1]);
  s.upright = flat < upright_below;
  s.flat_direction[0] = s.upright ? 0.f : s.direction[0], s.flat_direction[1] = s.upright ? 0.f : s.direction[1];
  s.flat = s.upright ? 0.f : flat, s.per_flat = 1 / std::max(flat, upright_below);
  s.per_upward = 1 / (std::fabs(s.direction[2]) < nearly_none ? nearly_none : s.direction[2]);
  return s;
}

/// Mirrors the path about the plane z = 0 through the brick's corner. A body that becomes narrower upwards is mirrored too, so that it
/// becomes wider upwards and needs no code of its own.
inline LocalSweep upside_down(LocalSweep s) {
  s.from[2] = -s.from[2], s.direction[2] = -s.direction[2], s.rise = -s.rise;
  s.per_upward = 1 / (std::fabs(s.direction[2]) < nearly_none ? nearly_none : s.direction[2]);
  return s;
}

}  // namespace kadr
