#pragma once
// PathModes: which modes for corners a control has. Two programs are compared only by the modes that both controls have; by exact stops if
// the second control has them.

#include "config/control_def.h"

namespace kadr {

struct PathModes {
  bool exact = false;      // exact stops by code: G9, G60, G61
  bool tolerance = false;  // a tolerance for the path: G64 P
  bool speeds = false;     // slower at inner corners, or not slowed down: G62, G63
  bool smoothing = false;  // G5.1 Q
  friend PathModes operator&(PathModes a, PathModes b) {
    return {a.exact && b.exact, a.tolerance && b.tolerance, a.speeds && b.speeds, a.smoothing && b.smoothing};
  }
};

PathModes path_modes_of(const ControlDef& def);

}  // namespace kadr
