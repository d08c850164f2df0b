#pragma once
// The sheets of a lattice cell: which of the cell's crossed edges belong together. Used by stock/surface/surface.
//
// The number of a corner has the bits 1 for the far side along X, 2 along Y, 4 along Z. Edge 4 f + a + 2 b runs along the axis f from
// the corner with the bit a along (f + 1) % 3 and b along (f + 2) % 3. On each face of the cell the crossed edges are joined in
// pairs; a chain of pairs closes to a loop, and each loop spans a sheet with a vertex of its own (Nielson, Dual Marching Cubes,
// 2004). A face with material at two diagonal corners has two pairs, which separate the material. If in both adjacent cells these two
// pairs belong to one sheet, the mesh would have one edge twice: such a face separates the air instead, which gives two sheets in
// each cell (Wenger, Isosurfaces, 2013, 5.4).
//
//   law  surfaces of any signs are closed two-manifolds   (tests/stock/sheets_test)

#include <array>
#include <cstdint>

namespace kadr {

inline constexpr int cell_edges = 12, cell_faces = 6;
inline constexpr std::uint8_t no_sheet = 0xff;

struct Sheets {
  std::array<std::uint8_t, cell_edges> of_edge;  // no_sheet if the edge is not crossed
  std::uint8_t count;
  std::uint8_t doubled;  // bits of the faces where both pairs belong to one sheet; face 2 f + s is at the near (0) or far (1) side along f
};

/// `corners` has one bit per corner, 1 for material. `parts_air` has the bits of the faces that separate the air.
Sheets sheets_of(unsigned corners, unsigned parts_air);

/// Returns the sheets of a cell whose faces all separate the material.
const Sheets& plain_sheets(unsigned corners);

}  // namespace kadr
