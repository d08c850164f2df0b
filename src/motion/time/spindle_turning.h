#pragma once
// SpindleTurning is the commanded rotation of a spindle. INFERRED: the spindle reaches a commanded speed at once.

#include <algorithm>

#include "action/action.h"

namespace kadr {

struct SpindleTurning {
  double rpm = 0;  // commanded speed, rev/min
  // True: the spindle rotates at `rpm`. The value is also true at the program start; if the set-up states that the spindle is at rest,
  // `rpm` is 0 at the program start.
  bool on = true;
  bool reversed = false;  // true: counter-clockwise rotation (M4)

  /// The speed, rev/min, that a spindle without a known limit does not exceed under constant surface speed when the tool moves towards the
  /// rotation centre. INFERRED: this limit applies even if the program states no limit.
  static constexpr double fastest = 1e5;
  double most_rpm = fastest;  // highest speed of the spindle, rev/min; a greater speed under constant surface speed is reduced to it

  SurfaceSpeed surface{};  // the law of constant surface speed, for the main spindle only

  double now() const { return on ? rpm : 0; }
  /// Returns the spindle speed, rev/min, while the tool is at the position `work` in work coordinates.
  double at(const Axes& work) const { return on && surface.on ? by_surface(work) : now(); }
  /// Updates the spindle speed after a motion that ended at the position `work` in work coordinates.
  void arrive(const Axes& work) {
    if (surface.on) rpm = by_surface(work);
  }

  /// Converts a speed in rev/min to degrees per second; clockwise is positive.
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
  void take(const Speed& speed) { rpm = speed.surface ? std::min(speed.rpm, most_rpm) : speed.value; }

 private:
  double by_surface(const Axes& work) const { return std::min(surface.rpm(work, rpm), most_rpm); }
};

}  // namespace kadr
