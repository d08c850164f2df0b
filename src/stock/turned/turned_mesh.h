#pragma once
// Converts the region of a turned part to a mesh by revolving its polygons. It is used by cli/cut_turned and
// stock/turned/turned_picture.

#include "stock/mesh/mesh.h"
#include "stock/turned/turned_stock.h"

namespace kadr {

/// Returns a closed mesh of the body of revolution about Z.
///   deviation  greatest distance of the mesh from the body, mm: one half for the chords around the axis, one half for the corners of the
///              polygons that are left out
Mesh turned_mesh(const TurnedRegion& region, double deviation);

/// Returns how many chords replace a circle of this radius, mm.
int chords_around(double radius, double deviation);

}  // namespace kadr
