#pragma once
// G2, G3: circles, spirals, helices, cones, in any plane and on surfaces (spec/nct/04 4.3).

#include "control/block/arc.h"

namespace kadr {
class Emitter;
struct Call;
}  // namespace kadr

namespace kadr::fanuc {

/// Returns the arc with the radius that the word R gives (4.3). If R is too short, the centre is on the chord, at the distance R from the
/// start point.
///   radius, shortfall  mm; `shortfall`: by how much the diameter may be shorter than the chord
///   alarms             radius_too_small; full_circle_by_radius: both ends are the same point
Result<PlaneArc> arc_by_short_radius(const ArcEnds& ends, double radius, double shortfall);

/// Executes the arc of the block, if the block has one.
///   alarms  center_missing, arc_not_in_plane (2015), radius_mismatch (2012), value_out_of_range (L), those of automatic_geometry.h
Status arc(Emitter& m, const Call& call, Turn turn);

}  // namespace kadr::fanuc
