#pragma once
// PolarPath: a path programmed in a plane and executed by a linear and a rotary axis (NCT 4.5). With (u, w) the point in the plane, p the
// perpendicular offset of the rotation centre in mm, and `side` the sign (±1) of the linear axis' position:
//   linear = side · sqrt(u² + w² − p²),   rotary = atan2(side·w, side·u) − atan2(p, linear), continuous from the start of the path.

#include "action/flat_path.h"

namespace kadr {

/// Positions of the two axes in mm and degrees, or their derivatives in mm and degrees per unit of `part`.
struct PolarAxes {
  double linear = 0;
  double rotary = 0;
};

/// The path of the linear and the rotary axis. A PolarPath refers to the path in the plane, which must exist longer than the PolarPath.
class PolarPath {
 public:
  /// Creates the view. `side`: sign of the linear axis' position; `offset`: p, mm; `rotary_start`: position of the rotary axis at part 0,
  /// degrees.
  PolarPath(const FlatPath& path, double side, double offset, double rotary_start)
      : path_(path), side_(side), offset_(offset), rotary_start_(rotary_start) {}

  PolarAxes at(double part) const;

  /// Returns the derivative of at() by `part`. At the rotation centre itself, the rotary axis has speed 0.
  PolarAxes rates(double part) const;

  /// Returns the distance, in mm, between the tool and the rotation centre at `part`.
  double distance(double part) const { return length(path_.at(part)); }

  /// Returns the `part` (0 to 1) at which the tool is nearest to the rotation centre: exact for a line, found by search for an arc.
  double nearest() const;

  /// Returns the least and the greatest position of both axes on the path.
  void extremes(PolarAxes& least, PolarAxes& most) const;

  /// Returns the number of equal parts of the path whose chords keep the linear axis within `chord` mm of its travel.
  int pieces(double chord) const;

 private:
  double linear_at(Vec2 point) const;
  double skew_deg(Vec2 point) const;

  const FlatPath& path_;
  double side_;
  double offset_;
  double rotary_start_;
};

}  // namespace kadr
