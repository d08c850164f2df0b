#pragma once
// SurfaceSpeed: constant surface speed of a spindle (nct 11.5). The speed n in rev/min follows from the surface speed v in m/min and from
// the diameter D in mm, which is twice the position of an axis:
//   n = min(max(1000 v / (π D), least), most)      D = 2 |position in the work coordinate system|

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/vec.h"

namespace kadr {

struct SurfaceSpeed {
  bool on = false;          // surface speed is in force; false: the spindle keeps its present speed in rev/min
  std::uint8_t number = 1;  // number of the spindle
  std::uint8_t axis = 0;    // index of the axis whose position is the radius
  double metres = 0;        // surface speed, m/min
  double least = 0;         // lowest spindle speed, rev/min
  double most = no_limit;

  static constexpr double no_limit = 1e300;
  // value of `axis` if the parameter names no axis; the spindle then has the speed for the rotation centre
  static constexpr std::uint8_t no_axis = 255;

  /// Returns the distance from the rotation centre, mm, at which this surface speed gives the spindle speed `rpm`.
  double radius(double rpm) const { return mm_per_m * metres / (2 * pi * rpm); }

  /// Returns the spindle speed in rev/min at a position in work coordinates.
  double rpm(const Axes& work) const {
    const double diameter = axis < work.size() ? 2 * std::fabs(work[axis]) : 0;
    return std::min(std::max(diameter > 0 ? mm_per_m * metres / (pi * diameter) : no_limit, least), most);
  }
  /// Returns the spindle speed in rev/min at a position in work coordinates; `before` is the previous speed. INFERRED: at the rotation
  /// centre, if there is no upper limit, the spindle keeps the previous speed.
  double rpm(const Axes& work, double before) const {
    const double now = rpm(work);
    return now < no_limit ? now : before;
  }

 private:
  static constexpr double mm_per_m = 1000;
};

}  // namespace kadr
