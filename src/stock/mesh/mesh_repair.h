#pragma once
// Repairs a mesh from elsewhere into a solid, closed and with its outside outwards, or reports what is wrong with it and where.

#include <string>
#include <tl/expected.hpp>

#include "stock/mesh/mesh.h"

namespace kadr {

struct MeshRules {
  std::size_t memory = std::size_t(1) << 30;  // bytes for everything that reading needs
  double weld = 0.005;                        // mm: points of open edges that are nearer than this are merged
  double reach = 100'000;                     // mm from the origin; no machine is larger
};

struct SolidMesh {
  Mesh mesh;
  std::vector<std::string> notes;  // messages about what was repaired
};

/// Merges points at the same position and removes triangles that have two equal corners. Only if edges are then open: merges points
/// within `weld` of each other and turns triangles with the wrong orientation. Shells that are inside out and are not cavities are
/// turned.
///   returns  a solid, or an error sentence with triangle, position and the number of open edges
tl::expected<SolidMesh, std::string> solid_of(Mesh mesh, const MeshRules& rules);

/// Estimates the memory, in bytes, that reading and solid_of need for this number of triangles.
constexpr std::size_t solid_bytes(std::size_t triangles) { return triangles * 160; }

/// Returns a message if there are more triangles than the memory permits, else an empty string.
std::string told_too_many(std::size_t triangles, const MeshRules& rules);

}  // namespace kadr
