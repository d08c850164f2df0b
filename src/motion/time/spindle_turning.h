#pragma once
// SpindleTurning: the commanded rotation of a spindle. INFERRED: the spindle reaches a commanded speed at once.

#include <algorithm>

#include "action/action.h"

namespace kadr {

struct SpindleTurning {
  double rpm = 0;  // commanded speed, rev/min
  // true: the spindle rotates at `rpm`. Also true at the program start; a spindle that the set-up states to be at rest has rpm 0 then
  bool on = true;
  bool reversed = false;  // true: counter-clockwise rotation (M4)

  SurfaceSpeed surface{};  // constant surface speed, for the main spindle only

  double now() const { return on ? rpm : 0; }
  /// Returns the speed while the tool is at this position, work coordinates, rev/min.
  double at(const Axes& work) const { return on && surface.on ? by_surface(work) : now(); }
  /// Reports that a motion ended at the position `work`, work coordinates.
  void arrive(const Axes& work) {
    if (surface.on) rpm = by_surface(work);
  }

  /// Converts a speed to degrees per second, clockwise.
  double degrees(double at_rpm) const {
    constexpr double per_second_of_rpm = 360.0 / 60;
    return at_rpm * per_second_of_rpm * (reversed ? -1 : 1);
  }

  void take(const Spindle& spindle) {
    on = spindle.dir == SpindleDir::cw || spindle.dir == SpindleDir::ccw;
    if (!on) return;
    rpm = spindle.rpm;
    reversed = spindle.dir == SpindleDir::ccw;
  }
  void take(const Speed& speed) { rpm = speed.surface ? speed.rpm : speed.value; }

 private:
  /// Upper bound of the speed when the tool moves towards the rotation centre. INFERRED: it applies even if no limit is stated.
  static constexpr double fastest = 1e5;  // rev/min
  double by_surface(const Axes& work) const { return std::min(surface.rpm(work, rpm), fastest); }
};

}  // namespace kadr
