#pragma once
// Arcs and threads by points that a cycle has found.

#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {

/// In the plane in force, with the checks of G2, G3. `center`: in the plane; `to`: programmed coordinates.
Status arc_to(Emitter& m, Span where, Turn turn, const Axes& to, Vec2 center, AxisMask named);
/// Led by the spindle, `lead` mm a turn.
Status thread_to(Emitter& m, const Axes& to, AxisMask named, double lead);

}  // namespace kadr::linuxcnc
