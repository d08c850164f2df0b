#pragma once
// SpindleTurning: how a spindle turns, by what is commanded of it. INFERRED: it takes its speed at once.

#include <algorithm>

#include "action/action.h"

namespace kadr {

struct SpindleTurning {
  double rpm = 0;         // commanded, rev/min
  bool on = true;         // the setup may say that it stands: then rpm is 0
  bool reversed = false;  // counter-clockwise (M4)

  SurfaceSpeed surface{};  // of the main spindle

  double now() const { return on ? rpm : 0; }
  /// Where the tool is there, work coordinates.
  double at(const Axes& work) const { return on && surface.on ? by_surface(work) : now(); }
  /// A motion ends there.
  void arrive(const Axes& work) {
    if (surface.on) rpm = by_surface(work);
  }

  /// Degrees a second, clockwise.
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
  /// INFERRED: towards the centre none turns faster than this, though nobody states a limit.
  static constexpr double fastest = 1e5;  // rev/min
  double by_surface(const Axes& work) const { return std::min(surface.rpm(work, rpm), fastest); }
};

}  // namespace kadr
