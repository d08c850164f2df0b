#pragma once
// A mesh that someone else made becomes a solid: closed, its outside outside; or it is told what is wrong with it and where.

#include <string>
#include <tl/expected.hpp>

#include "stock/mesh/mesh.h"

namespace kadr {

struct MeshRules {
  std::size_t memory = std::size_t(1) << 30;  // bytes for all that reading takes
  double weld = 0.005;                        // mm: points of open edges that are nearer to each other are one
  double reach = 100'000;                     // mm from the origin; no machine is larger
};

struct SolidMesh {
  Mesh mesh;
  std::vector<std::string> notes;  // what was repaired, told
};

/// Points at the same place become one, triangles without area between equal points go. Only if edges are then open: points within
/// `weld` of each other are joined, triangles that go round the wrong way turned. Shells that are inside out and not hollows are turned.
///   returns  a solid, or an error sentence with triangle, place and how many edges are open
tl::expected<SolidMesh, std::string> solid_of(Mesh mesh, const MeshRules& rules);

/// Bytes that reading and solid_of take for so many triangles.
constexpr std::size_t solid_bytes(std::size_t triangles) { return triangles * 160; }

/// More triangles than the memory allows, told; empty: they fit.
std::string told_too_many(std::size_t triangles, const MeshRules& rules);

}  // namespace kadr
