#pragma once
// What of a closed mesh lies within a box: its volume and its area there, exactly. For stock/blank and session/cutting.

#include "stock/mesh/mesh.h"

namespace kadr {

struct MeshWithin {
  double volume = 0;  // mm³ inside both
  double area = 0;    // mm² of the mesh's own triangles
};

///   law  of boxes that together are a larger one the volumes add up   (tests/stock/window_test)
MeshWithin mesh_within(const Mesh& mesh, const Box3& box);

}  // namespace kadr
