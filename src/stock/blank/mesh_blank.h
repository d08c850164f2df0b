#pragma once
// A blank of any shape, built from a closed mesh.

#include "stock/blank/blank.h"
#include "stock/mesh/triangle_across.h"

namespace kadr {

/// Returns a blank whose surface is the mesh. A point is inside the blank if the surface winds around the point at least once. So solid
/// bodies may overlap or contain each other, and a cavity is a shell whose triangles face the other way.
///   pre  each edge is used as often in one direction as in the other (edges_of(mesh).open == 0); the mesh has at least one triangle
std::shared_ptr<const Blank> mesh_blank(Mesh mesh);

/// Sorts the hits (intersections) of one line with a mesh, and appends to `ranges` the intervals in which the line is inside the mesh.
void take_ranges(MeshHit* first, MeshHit* last, std::vector<LineRange>& ranges);

/// Returns the memory in bytes of a mesh blank: the mesh itself and the index of its triangles.
std::size_t mesh_blank_bytes(std::size_t triangles);

}  // namespace kadr
