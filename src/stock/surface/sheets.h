#pragma once
// Divides the surface in a lattice cell into sheets: each sheet connects some of the cell edges that the surface crosses. Used by
// stock/surface/surface.
//
// In the number of a corner, bit 1 means the far side of the cell along X, bit 2 along Y, bit 4 along Z. Edge 4 f + a + 2 b is parallel to
// the axis f and starts at the corner with the bit a along (f + 1) % 3 and the bit b along (f + 2) % 3. On each face of the cell the
// crossed edges are joined in pairs. A chain of pairs closes to a loop, and each loop bounds a sheet, which has its own vertex (Nielson,
// Dual Marching Cubes, 2004). A face with material at two diagonal corners has two pairs; normally the pairs are chosen so that the
// material at the two corners is separated. If in both cells next to the face these two pairs belong to one sheet, the mesh would contain
// an edge twice. In this case the pairs are chosen so that the air is separated, which gives two sheets in each cell (Wenger, Isosurfaces,
// 2013, 5.4).
//
//   law  the surface is a closed two-manifold, whichever lattice points are material   (tests/stock/sheets_test)

#include <array>
#include <cstdint>

namespace kadr {

inline constexpr int cell_edges = 12, cell_faces = 6;
inline constexpr std::uint8_t no_sheet = 0xff;

struct Sheets {
  std::array<std::uint8_t, cell_edges> of_edge;  // sheet of each edge; no_sheet if the surface does not cross the edge
  std::uint8_t count;
  std::uint8_t
      // One bit for each face whose two pairs belong to one sheet. Bit 2 f means the face at the near end of the axis f, and bit 2 f + 1
      // the face at the far end.
      doubled;
};

/// Returns the sheets of a cell. `corners` has one bit per corner, 1 for material. `parts_air` has one bit per face, 1 if the pairs of the
/// face separate the air.
Sheets sheets_of(unsigned corners, unsigned parts_air);

/// Returns the sheets of a cell in which the pairs of every face separate the material.
const Sheets& plain_sheets(unsigned corners);

}  // namespace kadr
