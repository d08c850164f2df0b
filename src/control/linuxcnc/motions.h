#pragma once
// Arcs and threading motions to points that a canned cycle has computed.

#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {

/// Moves along an arc in the plane in force, with the checks of G2, G3. `center`: coordinates in that plane; `to`: programmed coordinates.
Status arc_to(Emitter& m, Span where, Turn turn, const Axes& to, Vec2 center, AxisMask named);
/// Moves to `to` synchronised with the spindle; `lead` is the thread lead in mm per revolution.
Status thread_to(Emitter& m, const Axes& to, AxisMask named, double lead);

}  // namespace kadr::linuxcnc
