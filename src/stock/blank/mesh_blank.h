#pragma once
// A blank of any shape, from a closed mesh.

#include "stock/blank/blank.h"
#include "stock/mesh/triangle_across.h"

namespace kadr {

/// A point is inside if the surface winds around it at least once: bodies may overlap or contain each other, and cavities are shells
/// turned inside out.
///   pre  each edge is used as often in one direction as in the other (edges_of(mesh).open == 0); at least one triangle
std::shared_ptr<const Blank> mesh_blank(Mesh mesh);

/// Appends the segments of a line that lie inside to `ranges`; sorts the hits.
void take_ranges(MeshHit* first, MeshHit* last, std::vector<LineRange>& ranges);

/// Returns the memory of the mesh itself and of the index of its triangles.
std::size_t mesh_blank_bytes(std::size_t triangles);

}  // namespace kadr
