#pragma once
// A blank of any form, from a closed mesh.

#include "stock/blank/blank.h"
#include "stock/mesh/triangle_across.h"

namespace kadr {

/// Inside is what the surface winds about at least once: bodies may lie one within the other, hollows are shells inside out.
///   pre  every edge is gone along as often one way as the other (edges_of(mesh).open == 0); at least one triangle
std::shared_ptr<const Blank> mesh_blank(Mesh mesh);

/// The stretches of a line that lie inside, put behind `ranges`; sorts the hits.
void take_ranges(MeshHit* first, MeshHit* last, std::vector<LineRange>& ranges);

/// Of the mesh itself and what finds its triangles.
std::size_t mesh_blank_bytes(std::size_t triangles);

}  // namespace kadr
