#pragma once
// The surface in one brick: the points of its cells, and the lattice edges that become faces. For stock/surface/surface.

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "stock/surface/crossings.h"
#include "stock/surface/sheets.h"

namespace kadr {

/// A cell with more than one sheet.
struct SeveralSheets {
  std::uint16_t cell;     // its column of cells, times 16, and its place in it
  std::uint16_t further;  // the point of its second sheet
  std::array<std::uint8_t, cell_edges> of_edge;
};

/// A lattice edge that the surface goes through: it is a face between the points of the four cells around.
struct CrossedEdge {
  std::uint16_t x : 4, y : 4, z : 4, family : 2, leaves : 1;
};

struct SurfacePart {
  std::vector<float> points;
  std::vector<std::int32_t> made_by;
  std::vector<CrossedEdge> edges;
  // Of each column of cells: a bit for a cell that has points, and the point of the first of them; further sheets' points come last.
  std::array<std::uint16_t, brick_lines> cells{}, first{};
  std::vector<SeveralSheets> several;  // in the order of the cells
  std::uint32_t base = 0;              // of its points, among all

  /// The point of the sheet that has the edge, in a cell counted from the brick's corner.
  std::uint32_t point_of(const std::array<int, 3>& cell, int edge) const;
};

/// What a thread needs to make parts, kept from one to the next.
struct PartWork {
  BrickSigns signs;
  Crossings crossings;
};

/// nullptr: no surface goes through the brick's cells.
std::unique_ptr<SurfacePart> surface_part(const Stock& stock, const std::vector<ToolFaces>& tools, std::size_t brick, PartWork& work);

}  // namespace kadr
