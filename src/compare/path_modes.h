#pragma once
// PathModes: which codes for corners and exact stops a control has. Two programs are compared only in the modes that both controls have.
// Exact stops are compared only if the control of the second program has them.

#include "config/control/control_def.h"

namespace kadr {

struct PathModes {
  bool exact = false;      // exact stops by code: G9, G60, G61
  bool tolerance = false;  // a path tolerance: G64 P
  bool speeds = false;     // slower at inner corners (G62), or not slowed down (G63)
  bool smoothing = false;  // G5.1 Q
  friend PathModes operator&(PathModes a, PathModes b) {
    return {a.exact && b.exact, a.tolerance && b.tolerance, a.speeds && b.speeds, a.smoothing && b.smoothing};
  }
};

PathModes path_modes_of(const ControlDef& def);

}  // namespace kadr
