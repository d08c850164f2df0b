#pragma once
// SpindleTurning: how a spindle turns, by what is commanded of it. INFERRED: it takes its speed at once, and any surface speed makes
// the speed that the control counted where it was commanded.

#include "control/action.h"

namespace kadr {

struct SpindleTurning {
  double rpm = 0;         // commanded, rev/min
  bool on = true;         // the setup may say that it stands: then rpm is 0
  bool reversed = false;  // counter-clockwise (M4)

  double now() const { return on ? rpm : 0; }

  void take(const Spindle& spindle) {
    on = spindle.dir == SpindleDir::cw || spindle.dir == SpindleDir::ccw;
    if (!on) return;
    rpm = spindle.rpm;
    reversed = spindle.dir == SpindleDir::ccw;
  }
  void take(const Speed& speed) { rpm = speed.surface ? speed.rpm : speed.value; }
};

}  // namespace kadr
