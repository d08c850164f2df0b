#pragma once
// Computes the normal of a surface that a turning tool has cut: the normal of the swept insert outline at its point nearest to the
// surface point. Used by stock/surface/crossings.
//
//   law  the normal is perpendicular to every direction in which the distance from the swept ring is constant   (tests/stock/turn_test)

#include "stock/surface/cut_normal.h"

namespace kadr {

/// Returns the outward normal of the remaining material at the crossing `place`.
///   from_axis  position of the lattice's corner relative to the axis about which the part spins, mm
Vec3 turned_normal(const KeptSweep& sweep, const ToolShape& tool, const CutPlace& place, const Vec3& from_axis);

}  // namespace kadr
