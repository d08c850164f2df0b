#pragma once
// Turns a computed arc into a motion where no transformation is active. Used by the dialects that read arcs by their own rules.

#include "control/block/arc.h"
#include "control/emitter.h"

namespace kadr {

/// Moves to `end` along the arc, in the selected plane.
///   end    programmed coordinates; `named`: axes with a word
///   turns  whole revolutions in addition to the arc
Motion& arc_motion(Emitter& m, const PlaneArc& arc, Turn turn, const Axes& end, AxisMask named, double turns = 0);

}  // namespace kadr
