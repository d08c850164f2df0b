#pragma once
// Computes the surface in one brick: the mesh points in its cells, and the crossed cell edges, which later become faces of the mesh.
// Used by stock/surface/surface.

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "stock/surface/crossings.h"
#include "stock/surface/sheets.h"

namespace kadr {

/// A cell that contains more than one sheet of the surface.
struct SeveralSheets {
  std::uint16_t cell;     // number of the cell: 16 · (index of the cell's column along Z) + (index of the cell in the column)
  std::uint16_t further;  // number of the mesh point of the cell's second sheet
  std::array<std::uint8_t, cell_edges> of_edge;
};

/// A cell edge that the surface crosses. The mesh gets a face between the points of the four cells around this edge.
struct CrossedEdge {
  std::uint16_t x : 4, y : 4, z : 4, family : 2, leaves : 1;
};

struct SurfacePart {
  std::vector<float> points;
  std::vector<std::int32_t> made_by;
  std::vector<CrossedEdge> edges;
  // For each column of cells along Z: one bit for each cell that has mesh points, and the number of the point of the first of these cells.
  // Points of further sheets follow after the first points of all cells.
  std::array<std::uint16_t, brick_lines> cells{}, first{};
  std::vector<SeveralSheets> several;  // cells with several sheets, in the order of the cells
  std::uint32_t base = 0;              // number of this brick's first point in the whole mesh

  /// Returns the number of the mesh point of the sheet that contains the edge `edge` of a cell. The indices `cell` are counted from the
  /// brick's corner.
  std::uint32_t point_of(const std::array<int, 3>& cell, int edge) const;
};

/// Buffers of one thread, which are reused for each brick.
struct PartWork {
  BrickSigns signs;
  Crossings crossings;
};

/// Returns the surface in a brick; nullptr if the surface crosses no cell of the brick.
std::unique_ptr<SurfacePart> surface_part(const Stock& stock, const std::vector<ToolFaces>& tools, std::size_t brick, PartWork& work);

}  // namespace kadr
