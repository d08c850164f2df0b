#pragma once
// The surface in one brick: the points of its cells, and the crossed lattice edges, which become faces. Used by
// stock/surface/surface.

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "stock/surface/crossings.h"
#include "stock/surface/sheets.h"

namespace kadr {

/// A cell with more than one sheet.
struct SeveralSheets {
  std::uint16_t cell;     // number of its column of cells times 16, plus its position in the column
  std::uint16_t further;  // number of the second sheet's point
  std::array<std::uint8_t, cell_edges> of_edge;
};

/// A lattice edge that the surface crosses; it becomes a face between the points of the four cells around it.
struct CrossedEdge {
  std::uint16_t x : 4, y : 4, z : 4, family : 2, leaves : 1;
};

struct SurfacePart {
  std::vector<float> points;
  std::vector<std::int32_t> made_by;
  std::vector<CrossedEdge> edges;
  // For each column of cells: one bit per cell that has points, and the number of the first cell's point. Points of further sheets
  // come last.
  std::array<std::uint16_t, brick_lines> cells{}, first{};
  std::vector<SeveralSheets> several;  // in the order of the cells
  std::uint32_t base = 0;              // number of its first point among all points

  /// Returns the point of the sheet that contains the edge, in a cell counted from the brick's corner.
  std::uint32_t point_of(const std::array<int, 3>& cell, int edge) const;
};

/// Buffers of a thread, reused from part to part.
struct PartWork {
  BrickSigns signs;
  Crossings crossings;
};

/// Returns nullptr if no surface crosses the brick's cells.
std::unique_ptr<SurfacePart> surface_part(const Stock& stock, const std::vector<ToolFaces>& tools, std::size_t brick, PartWork& work);

}  // namespace kadr
