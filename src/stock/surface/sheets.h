#pragma once
// The sheets of a lattice cell: which of its edges that the surface crosses belong together. For stock/surface/surface.
//
// A corner of the cell is numbered by its bits: 1 for the far side along X, 2 along Y, 4 along Z. Edge 4 f + a + 2 b runs along the axis f
// from the corner with the bit a along (f + 1) % 3 and b along (f + 2) % 3. On each face of the cell the crossed edges are joined in
// pairs; a chain of pairs closes to a loop, and a loop spans a sheet, which has a vertex of its own (Nielson, Dual Marching Cubes, 2004).
// A face whose corners are material crosswise has two pairs; they part the material. Where both cells beside it have both pairs in one
// sheet, that would be one mesh edge twice: such a face parts the air instead, which makes two sheets of each (Wenger, Isosurfaces,
// 2013, 5.4).
//
//   law  surfaces of any signs are closed two-manifolds   (tests/stock/sheets_test)

#include <array>
#include <cstdint>

namespace kadr {

inline constexpr int cell_edges = 12, cell_faces = 6;
inline constexpr std::uint8_t no_sheet = 0xff;

struct Sheets {
  std::array<std::uint8_t, cell_edges> of_edge;  // no_sheet: not crossed
  std::uint8_t count;
  std::uint8_t doubled;  // bits of the faces that both pairs of one sheet go through; face 2 f + s lies at the near or far side along f
};

/// `corners`: a bit each, 1 is material. `parts_air`: faces that part the air.
Sheets sheets_of(unsigned corners, unsigned parts_air);

/// Of cells whose faces all part the material.
const Sheets& plain_sheets(unsigned corners);

}  // namespace kadr
