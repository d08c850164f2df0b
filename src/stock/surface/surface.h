#pragma once
// The surface of the remaining material as a closed, oriented triangle mesh.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"
#include "stock/stock.h"

namespace kadr {

/// The surface in one brick of a portion: where its points and triangles begin in the surface of the portion.
struct SurfaceBrick {
  std::uint64_t number;  // number of the brick among all bricks of the lattice
  std::size_t first_point, first_triangle, triangles;
};

/// The surface of a stock. Lengths are in mm, in the work coordinates of the blank.
struct Surface : Mesh {
  std::vector<std::int32_t> made_by;  // for each point: number of the last sweep that cut at this point; of_blank if no sweep did
  // Only of a portion: the bricks with points or triangles, in their order, and the number of points that belong to neighbouring portions.
  // These are the last points; triangles of the portion have corners there.
  std::vector<SurfaceBrick> bricks;
  std::size_t others_points = 0;

  std::size_t own_points() const { return point_count() - others_points; }
};

/// Computes the surface by dual contouring with the normals of the tools: each lattice cell that the surface crosses gets one point for
/// each sheet of surface in the cell, where the tangent planes at the sheet's crossings meet (Ju et al. 2002). Sharp edges stay sharp.
/// Features thinner than a cell that lie between lattice points are lost.
///   law     the surface is a closed two-manifold: each edge is used once in each direction   (tests/stock/surface_test)
///   law     the result is the same, bit for bit, for any number of threads
///   law     the triangles of all portions, in the order of the bricks, are those of the whole stock, bit for bit
///   (tests/stock/portion_test) memory  the result takes 40 bytes per point (there are two triangles per point); the computation needs 20
///   more per point, and
///           200 kB per thread
Surface surface_of(const Stock& stock);

}  // namespace kadr
