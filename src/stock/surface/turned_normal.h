#pragma once
// The normal of a surface cut by a turning tool: the normal of the swept outline where it is nearest. Used by
// stock/surface/crossings.
//
//   law  perpendicular to the directions in which the distance from the swept ring is constant   (tests/stock/turn_test)

#include "stock/surface/cut_normal.h"

namespace kadr {

/// Returns the outward normal of the remaining material.
///   from_axis  the lattice's corner, relative to the axis that the part spins about
Vec3 turned_normal(const KeptSweep& sweep, const ToolShape& tool, const CutPlace& place, const Vec3& from_axis);

}  // namespace kadr
