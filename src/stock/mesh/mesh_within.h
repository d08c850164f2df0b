#pragma once
// The volume and area of a closed mesh inside a box, exactly. Used by stock/blank and session/cutting.

#include "stock/mesh/mesh.h"

namespace kadr {

struct MeshWithin {
  double volume = 0;  // mm³ inside both
  double area = 0;    // mm² of the mesh's own triangles
};

///   law  for boxes that together form a larger one the volumes add up   (tests/stock/window_test)
MeshWithin mesh_within(const Mesh& mesh, const Box3& box);

}  // namespace kadr
