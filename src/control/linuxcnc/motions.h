#pragma once
// Emits arcs and threading motions to points that a canned cycle has computed.

#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {

/// Moves along an arc in the plane in force, with the checks of G2, G3.
///   to      end point, programmed coordinates
///   center  centre of the arc, programmed coordinates in the plane
Status arc_to(Emitter& m, Span where, Turn turn, const Axes& to, Vec2 center, AxisMask named);
/// Moves to the programmed point `to` in synchronism with the spindle. `lead`: lead of the thread in mm per revolution.
Status thread_to(Emitter& m, const Axes& to, AxisMask named, double lead);

}  // namespace kadr::linuxcnc
