// Computes the mesh points and crossed cell edges of a brick. Used by stock/surface/surface.

#include "stock/surface/surface_part.h"

#include <algorithm>
#include <memory>

#include "stock/surface/cell_vertex.h"

namespace kadr {
namespace {

struct PartMaker {
  const Stock& stock;
  std::size_t brick;
  const PartWork& work;
  SurfacePart& part;
  Vec3 corner;
  double cell;
  std::vector<float> further_points{};
  std::vector<std::int32_t> further_by{};

  void take_column(int x, int y);
  void take_cell(const std::array<int, 3>& at);
  void put(const CellVertex& vertex, const std::array<int, 3>& at, bool first_sheet);
  unsigned corners_in_other_bricks(const std::array<int, 3>& at) const;
  Sheets parted(const std::array<int, 3>& at, unsigned corners, unsigned doubled) const;
  void finish();
};

void PartMaker::put(const CellVertex& vertex, const std::array<int, 3>& at, bool first_sheet) {
  std::array<double, 3> low;
  for (std::size_t d = 0; d < 3; ++d) low[d] = (at[d] + 0.5) * cell;
  const std::array<double, 3> place = vertex.place(low, cell);
  std::vector<float>& points = first_sheet ? part.points : further_points;
  for (int d = 0; d < 3; ++d) points.push_back(float(place[std::size_t(d)] + along(corner, d)));
  (first_sheet ? part.made_by : further_by).push_back(vertex.made_by());
}

/// Returns the states of the corners of a cell, one bit per corner (stock/surface/sheets.h). The cell may be in another brick.
unsigned PartMaker::corners_in_other_bricks(const std::array<int, 3>& at) const {
  if (std::all_of(at.begin(), at.end(), [](int i) { return i >= 0 && i < brick_edge; })) return work.signs.corners(at[0], at[1], at[2]);
  const BrickPlace place = stock.lattice().place(brick);
  unsigned corners = 0;
  for (int q = 0; q < 8; ++q)
    corners |= unsigned(is_material(stock, {place.x * brick_edge + at[0] + (q & 1), place.y * brick_edge + at[1] + (q >> 1 & 1),
                                            place.z * brick_edge + at[2] + (q >> 2)}))
               << q;
  return corners;
}

/// Returns the sheets of a cell with a face whose two pairs both belong to one sheet. The air is separated on this face if, in the cell
/// beyond the face, both pairs belong to one sheet too. In each configuration of corners, at most one face has both pairs in one sheet.
Sheets PartMaker::parted(const std::array<int, 3>& at, unsigned corners, unsigned doubled) const {
  const int face = std::countr_zero(doubled);
  std::array<int, 3> neighbour = at;
  neighbour[std::size_t(face / 2)] += face % 2 ? 1 : -1;
  const bool by_both = (plain_sheets(corners_in_other_bricks(neighbour)).doubled >> (face ^ 1) & 1) != 0;
  return by_both ? sheets_of(corners, doubled) : plain_sheets(corners);
}

void PartMaker::take_cell(const std::array<int, 3>& at) {
  const unsigned corners = work.signs.corners(at[0], at[1], at[2]);
  const Sheets& plain = plain_sheets(corners);
  const Sheets sheets = plain.doubled != 0 ? parted(at, corners, plain.doubled) : plain;
  std::array<CellVertex, 4> vertices;
  for (int e = 0; e < cell_edges; ++e) {
    const std::uint8_t sheet = sheets.of_edge[std::size_t(e)];
    if (sheet == no_sheet) continue;
    LatticeEdge edge{e / 4, at};
    edge.point[std::size_t((edge.family + 1) % 3)] += e & 1;
    edge.point[std::size_t((edge.family + 2) % 3)] += e >> 1 & 1;
    vertices[sheet].add(work.crossings.of(edge));
  }
  if (sheets.count > 1)
    part.several.push_back(
        {std::uint16_t((at[1] * brick_edge + at[0]) * brick_edge + at[2]), std::uint16_t(further_by.size()), sheets.of_edge});
  for (std::size_t i = 0; i < sheets.count; ++i) put(vertices[i], at, i == 0);
}

void PartMaker::take_column(int x, int y) {
  const std::uint32_t a = work.signs.column(x, y), b = work.signs.column(x + 1, y), c = work.signs.column(x, y + 1),
                      d = work.signs.column(x + 1, y + 1);
  const std::uint32_t any = a | b | c | d, all = a & b & c & d, mask = (1u << brick_edge) - 1;
  const std::uint32_t cells = (any | any >> 1) & ~(all & all >> 1) & mask;
  const std::size_t column = std::size_t(y * brick_edge + x);
  part.cells[column] = std::uint16_t(cells);
  part.first[column] = std::uint16_t(part.made_by.size());
  for (std::uint32_t left = cells; left != 0; left &= left - 1) take_cell({x, y, std::countr_zero(left)});
}

void PartMaker::finish() {
  for (SeveralSheets& s : part.several) s.further = std::uint16_t(s.further + part.made_by.size());
  part.points.insert(part.points.end(), further_points.begin(), further_points.end());
  part.made_by.insert(part.made_by.end(), further_by.begin(), further_by.end());
  // Frees unused memory, because the surface parts of all bricks are stored until the whole surface is computed.
  part.points.shrink_to_fit(), part.made_by.shrink_to_fit();
  each_unlike_edge(work.signs, brick_edge - 1, [&](const LatticeEdge& e, bool leaves) {
    part.edges.push_back({std::uint16_t(e.point[0] & 15), std::uint16_t(e.point[1] & 15), std::uint16_t(e.point[2] & 15),
                          std::uint16_t(e.family & 3), std::uint16_t(leaves)});
  });
  part.edges.shrink_to_fit();
}

}  // namespace

std::uint32_t SurfacePart::point_of(const std::array<int, 3>& cell, int edge) const {
  const std::size_t column = std::size_t(cell[1] * brick_edge + cell[0]);
  const unsigned below = cells[column] & ((1u << cell[2]) - 1);
  const std::uint32_t plain = base + first[column] + std::uint32_t(std::popcount(below));
  if (several.empty()) return plain;
  const std::size_t number = column * brick_edge + std::size_t(cell[2]);
  const auto found =
      std::lower_bound(several.begin(), several.end(), number, [](const SeveralSheets& s, std::size_t n) { return s.cell < n; });
  if (found == several.end() || found->cell != number) return plain;
  const std::uint8_t sheet = found->of_edge[std::size_t(edge)];
  return sheet == 0 ? plain : base + found->further + sheet - 1;
}

std::unique_ptr<SurfacePart> surface_part(const Stock& stock, const std::vector<ToolFaces>& tools, std::size_t brick, PartWork& work) {
  const BricksAround around(stock, stock.lattice().place(brick));
  if (around.same) return nullptr;
  work.signs.take(around, float(stock.lattice().cell()));
  work.crossings.take(stock, tools, brick, around, work.signs);
  if (work.crossings.none()) return nullptr;
  auto part = std::make_unique<SurfacePart>();
  PartMaker maker{stock, brick, work, *part, stock.lattice().corner(brick), stock.lattice().cell()};
  for (int y = 0; y < brick_edge; ++y)
    for (int x = 0; x < brick_edge; ++x) maker.take_column(x, y);
  maker.finish();
  return part;
}

}  // namespace kadr
