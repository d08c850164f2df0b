#pragma once
// G2, G3: circles, spirals, helices, cones, in any plane and on surfaces (spec/nct/04 4.3).

#include "control/block/arc.h"

namespace kadr {
class Emitter;
struct Call;
}  // namespace kadr

namespace kadr::fanuc {

/// Executes the arc of the block, if the block has one.
///   alarms  center_missing, arc_not_in_plane (2015), radius_mismatch (2012), value_out_of_range (L), those of automatic_geometry.h
Status arc(Emitter& m, const Call& call, Turn turn);

}  // namespace kadr::fanuc
