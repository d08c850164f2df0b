#pragma once
// The surface of the remaining material: triangles, closed and oriented.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"
#include "stock/stock.h"

namespace kadr {

/// Lengths in mm, in the work system of the blank.
struct Surface : Mesh {
  std::vector<std::int32_t> made_by;  // for each point: the last sweep that cut there, or of_blank
};

/// Dual contouring with the tools' own normals: each lattice cell that the surface crosses has a point for each sheet in it, where
/// the tangent planes of the crossings meet (Ju et al. 2002). Sharp edges are kept. Features thinner than a cell that lie between
/// lattice points are lost.
///   law     a closed two-manifold: each edge is used once in each direction   (tests/stock/surface_test)
///   law     the same bits for any number of threads
///   memory  the result takes 40 bytes per point (two triangles per point); 20 more during the computation, and 200 kB per thread
Surface surface_of(const Stock& stock);

}  // namespace kadr
