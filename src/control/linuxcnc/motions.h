#pragma once
// Arcs and threading motions to points that a canned cycle has computed.

#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {

/// Moves along an arc in the plane in force, with the checks of G2, G3.
///   to      end point, programmed coordinates
///   center  coordinates in that plane
Status arc_to(Emitter& m, Span where, Turn turn, const Axes& to, Vec2 center, AxisMask named);
/// Moves to the programmed point `to` in synchronism with the spindle. `lead`: lead of the thread, mm per revolution.
Status thread_to(Emitter& m, const Axes& to, AxisMask named, double lead);

}  // namespace kadr::linuxcnc
