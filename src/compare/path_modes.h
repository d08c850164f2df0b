#pragma once
// PathModes: what a control can be told about how corners are gone round. Of two programs that alone is compared which both controls have;
// exact stops, which the second one has.

#include "config/control_def.h"

namespace kadr {

struct PathModes {
  bool exact = false;      // it stops exactly where it is told: G9, G60, G61
  bool tolerance = false;  // a path within a tolerance: G64 P
  bool speeds = false;     // slower at inner corners, or not slowed down: G62, G63
  bool smoothing = false;  // G5.1 Q
  friend PathModes operator&(PathModes a, PathModes b) {
    return {a.exact && b.exact, a.tolerance && b.tolerance, a.speeds && b.speeds, a.smoothing && b.smoothing};
  }
};

PathModes path_modes_of(const ControlDef& def);

}  // namespace kadr
