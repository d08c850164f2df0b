#pragma once
// The normal of a surface that a turning tool has cut: that of the outline of what it swept, where it is nearest. For
// stock/surface/crossings.
//
//   law  upright to what the distance from the swept ring is level along   (tests/stock/turn_test)

#include "stock/surface/cut_normal.h"

namespace kadr {

/// Outward, of what is left.
///   from_axis  the lattice's corner, from the axis that the part spins about
Vec3 turned_normal(const KeptSweep& sweep, const ToolShape& tool, const CutPlace& place, const Vec3& from_axis);

}  // namespace kadr
