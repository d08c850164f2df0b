#pragma once
// The surface that portions have together, read brick by brick from their files: it is never in memory as a whole.

#include <vector>

#include "stock/mesh/stl.h"
#include "stock/portion/portion_file.h"

namespace kadr {

/// What is measured of the joined surface.
struct JoinedSurface {
  double volume = 0;              // enclosed volume, mm³
  double area = 0, cut_area = 0;  // area of all triangles, and of those that tools have made, mm²
  std::uint64_t triangles = 0;
  bool sound = true;  // false: a file is damaged, or its portion does not fit to the others
};

/// Reads the triangles of all portions in the order of the bricks.
///   ends   the ends of the same portions, as read from the files
///   write  receives each triangle; nullptr: the triangles are only measured
///   law    volume, areas and the sequence of triangles are those of the surface of the whole stock, bit for bit
JoinedSurface join_surfaces(std::vector<PortionReader>& portions, const std::vector<PortionEnd>& ends, StlWriter* write);

}  // namespace kadr
