#pragma once
// Emits the motion of an arc that has been computed, while no transformation is active. Used by dialects that have their own rules for
// reading arcs.

#include "control/block/arc.h"
#include "control/emitter.h"

namespace kadr {

/// Emits a motion along `arc`, which is in the selected plane.
///   end    end point, programmed coordinates
///   named  axes that have a word
///   turns  whole revolutions in addition to the arc
Motion& arc_motion(Emitter& m, const PlaneArc& arc, Turn turn, const Axes& end, AxisMask named, double turns = 0);

}  // namespace kadr
