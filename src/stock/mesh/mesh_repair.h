#pragma once
// Repairs a mesh from another program, so that the mesh is closed and its triangles face outwards, or reports the faults of the mesh with
// their positions.

#include <string>
#include <tl/expected.hpp>

#include "stock/mesh/mesh.h"

namespace kadr {

struct MeshRules {
  std::size_t memory = std::size_t(1) << 30;  // greatest memory in bytes for everything that is needed to read a mesh
  double weld = 0.005;                        // points of open edges are merged if their distance in mm is less than this
  double reach = 100'000;                     // greatest permitted distance of a point from the origin, mm; no machine is larger
};

struct SolidMesh {
  Mesh mesh;
  std::vector<std::string> notes;  // messages about the repairs
};

/// Merges points at the same position, and removes triangles with two equal corners. If edges are still open, merges points within
/// `weld` of each other, and turns triangles with the wrong orientation. Finally turns shells that are inside out, unless they are
/// cavities.
///   returns  a closed mesh, or an error sentence that names the triangle, the position and the number of open edges
tl::expected<SolidMesh, std::string> solid_of(Mesh mesh, const MeshRules& rules);

/// Returns an estimate of the memory in bytes that reading and solid_of() need for a mesh of `triangles` triangles.
constexpr std::size_t solid_bytes(std::size_t triangles) { return triangles * 160; }

/// Returns a message if there are more triangles than the memory limit permits, else an empty string.
std::string too_many_message(std::size_t triangles, const MeshRules& rules);

}  // namespace kadr
