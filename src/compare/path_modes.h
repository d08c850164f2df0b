#pragma once
// PathModes: the codes that a control has for corners and exact stops. Two programs are compared only in the modes that both controls have.
// Exact stops are compared only if the control of the second program has codes for them.

#include "config/control/control_def.h"

namespace kadr {

struct PathModes {
  bool exact = false;      // true if the control has codes for exact stops: G9, G60, G61
  bool tolerance = false;  // true if the control has a path tolerance: G64 P
  bool speeds = false;     // true if the control has codes for slower inner corners (G62) or for corners without reduced speed (G63)
  bool smoothing = false;  // true if the control has smoothing: G5.1 Q
  friend PathModes operator&(PathModes a, PathModes b) {
    return {a.exact && b.exact, a.tolerance && b.tolerance, a.speeds && b.speeds, a.smoothing && b.smoothing};
  }
};

PathModes path_modes_of(const ControlDef& def);

}  // namespace kadr
