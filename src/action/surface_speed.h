#pragma once
// SurfaceSpeed: constant surface speed of a spindle (nct 11.5). The speed n in rev/min follows from the surface speed v in m/min and the
// diameter D in mm, which the position of an axis gives:
//   n = min(max(1000 v / (π D), least), most)      D = 2 |position in the work coordinate system|

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/vec.h"

namespace kadr {

struct SurfaceSpeed {
  bool on = false;          // surface speed is switched on; if false, the spindle keeps its present speed in rev/min
  std::uint8_t number = 1;  // number of the spindle
  std::uint8_t axis = 0;    // index of the axis whose position is the radius
  double metres = 0;        // surface speed, m/min
  double least = 0;         // rev/min
  double most = no_limit;

  static constexpr double no_limit = 1e300;
  static constexpr std::uint8_t no_axis = 255;  // value of `axis` if the parameter names no axis: the speed is that at the rotation centre

  /// Returns the distance from the axis, in mm, at which this surface speed gives `rpm`.
  double radius(double rpm) const { return mm_per_m * metres / (2 * pi * rpm); }

  /// Returns the speed in rev/min at a position in work coordinates.
  double rpm(const Axes& work) const {
    const double diameter = axis < work.size() ? 2 * std::fabs(work[axis]) : 0;
    return std::min(std::max(diameter > 0 ? mm_per_m * metres / (pi * diameter) : no_limit, least), most);
  }
  /// Like rpm(work). INFERRED: at the rotation centre, without an upper limit, the speed remains `before`.
  double rpm(const Axes& work, double before) const {
    const double now = rpm(work);
    return now < no_limit ? now : before;
  }

 private:
  static constexpr double mm_per_m = 1000;
};

}  // namespace kadr
