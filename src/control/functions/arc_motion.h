#pragma once
// An arc that has been found becomes a motion, where nothing transforms coordinates. For the dialects that read arcs by rules of their own.

#include "control/block/arc.h"
#include "control/emitter.h"

namespace kadr {

/// Moves to `end` along the arc in the plane in force.
///   end    programmed coordinates; `named`: axes with a word
///   turns  whole ones besides those of the arc
Motion& arc_motion(Emitter& m, const PlaneArc& arc, Turn turn, const Axes& end, AxisMask named, double turns = 0);

}  // namespace kadr
