#pragma once
// Computes the exact volume and area of the part of a closed mesh that is inside a box. Used by stock/blank and session/cutting.

#include "stock/mesh/mesh.h"

namespace kadr {

struct MeshWithin {
  double volume = 0;  // volume inside both the mesh and the box, mm³
  double area = 0;    // area of the mesh's triangles inside the box, without the cut faces, mm²
};

///   law  the volumes in boxes that together form a larger box add up to the volume in the larger box   (tests/stock/window_test)
MeshWithin mesh_within(const Mesh& mesh, const Box3& box);

}  // namespace kadr
