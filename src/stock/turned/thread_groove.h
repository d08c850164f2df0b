#pragma once
// ThreadGroove: the helical groove of one pass of a threading insert. It is used by stock/turned/turned_surface, for display: volumes count
// the cylinder or cone into which a thread is cut.
//
//   radius                        At the angle θ of the part the tip of the insert is at z = start + lead · (k ± θ / 2π), k = 0, 1, 2 …
//     ▲ ╲    ╱╲    ╱╲    ╱        There the groove has the outline of the insert.
//     │  ╲__╱  ╲__╱  ╲__╱
//     └──────────────────▶ Z

#include <cstdint>
#include <optional>

#include "stock/turned/insert_sweep.h"

namespace kadr {

/// One pass. Points of the half plane: x is the radius, y is Z, mm.
struct ThreadGroove {
  TurnedPolygon outline;  // the insert relative to its tip, counter-clockwise; x is positive away from the axis
  Vec2 from, to;          // path of the tip; the radii are not negative
  double start = 0;       // a Z at which the tip is at the angle 0 of the part, on the helix continued beyond the path, mm
  double lead = 0;        // travel along Z per revolution, positive, mm
  bool is_outer = true;   // true: the groove is cut from outside; false: from inside
  bool left_handed = false;
  std::int32_t maker = -1;  // number for the caller of what cut it

  /// Returns the interval of Z in which the groove may remove material, mm: x is the least, y the greatest.
  Vec2 reach() const;
  /// Returns the radius at which the groove ends at an angle of the part (rad) and a Z: the material between it and the insert's side is
  /// removed. An outer groove that does not reach the place returns a huge radius, an inner one -1.
  double radius(double angle, double z) const;
  bool operator==(const ThreadGroove&) const = default;
};

/// Returns the outermost (or innermost) extent of a convex outline at a distance `z` along Z from its tip: the least x for an outer groove,
/// the greatest for an inner one. Returns nullopt beyond the outline.
std::optional<double> outline_at(const TurnedPolygon& outline, double z, bool least);

}  // namespace kadr
