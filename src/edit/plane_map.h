#pragma once
// PlaneMap: a mirror image, a rotation or a shift of the XY plane, mm. Mirror images about lines parallel to an axis and rotations by
// multiples of 90° map words to words; all others need both coordinates of each position.

#include "base/vec.h"

namespace kadr {

struct PlaneMap {
  Vec2 of_x{1, 0}, of_y{0, 1};  // images of the unit vectors
  Vec2 by;                      // image of the origin

  /// Returns the mirror image in which X (or Y) changes its sign about the line X = at (or Y = at).
  static PlaneMap mirror_x(double at) { return {{-1, 0}, {0, 1}, {2 * at, 0}}; }
  static PlaneMap mirror_y(double at) { return {{1, 0}, {0, -1}, {0, 2 * at}}; }
  /// Returns the rotation by `degrees`, counter-clockwise, about `centre`.
  static PlaneMap turn(double degrees, Vec2 centre) {
    const SinCos t = sincos_deg(degrees);
    PlaneMap map{{t.cos, t.sin}, {-t.sin, t.cos}, {}};
    map.by = centre - map.vector(centre);
    return map;
  }
  static PlaneMap shift(Vec2 by) { return {{1, 0}, {0, 1}, by}; }

  Vec2 vector(Vec2 v) const { return v.x * of_x + v.y * of_y; }
  Vec2 point(Vec2 p) const { return vector(p) + by; }
  /// True if the image of an axis is an axis, so that each word maps to one word.
  bool is_quarter() const { return of_x.x * of_x.y == 0 && of_y.x * of_y.y == 0; }
  /// True, for a quarter map, if X maps to Y.
  bool swaps() const { return of_x.x == 0; }
  bool mirrors() const { return cross(of_x, of_y) < 0; }
  /// Returns a point that the map leaves where it is; the origin if there is none.
  Vec2 fixed_point() const;
};

inline Vec2 PlaneMap::fixed_point() const {
  // (1 - M) p = by
  const double a = 1 - of_x.x, b = -of_y.x, c = -of_x.y, d = 1 - of_y.y, det = a * d - b * c;
  constexpr double flat = 1e-12;
  if (det > flat || det < -flat) return {(by.x * d - b * by.y) / det, (a * by.y - c * by.x) / det};
  if (mirrors()) return 0.5 * by;
  return {};
}

}  // namespace kadr
