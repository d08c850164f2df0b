#pragma once
// The surface of what is left: triangles, closed and oriented.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"
#include "stock/stock.h"

namespace kadr {

/// Lengths mm, in the work system of the blank.
struct Surface : Mesh {
  std::vector<std::int32_t> made_by;  // of each point: the last sweep that cut there; of_blank
};

/// Dual contouring with the tools' own normals: a point in each lattice cell that the surface goes through, for each sheet of it there,
/// where the tangent planes of its crossings meet (Ju et al. 2002). Sharp edges are kept; what is thinner than a cell and lies between
/// lattice points is not seen.
///   law     a closed two-manifold: each edge is gone along once each way   (tests/stock/surface_test)
///   law     the same bits for any number of threads
///   memory  40 bytes a point are handed back (two triangles a point); while it works 20 more, and 200 kB a thread
Surface surface_of(const Stock& stock);

}  // namespace kadr
