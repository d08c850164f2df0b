#pragma once
// Determines which lattice points of a brick, and of the next layer of points beyond the brick, are material. Used by stock/surface.

#include <array>
#include <cstdint>

#include "stock/stock.h"

namespace kadr {

inline constexpr int signs_edge = brick_edge + 1;

/// A brick and its seven neighbours in the positive directions. In the index of a neighbour, bit 1 means the next brick along X, bit 2
/// along Y, bit 4 along Z. Bricks outside the lattice are empty.
struct BricksAround {
  BricksAround(const Stock& stock, BrickPlace place);
  std::array<Stock::State, 8> state;
  std::array<const Brick*, 8> brick;
  bool same;  // true if the brick and its seven neighbours are all empty or all full, so that no surface is between them
};

/// One bit per lattice point; 1 means material. The bits are grouped in columns along Z, with the lowest point in bit 0. Only the intervals
/// on lattice lines along Z determine a bit. So each point has one state, even where lines of the other directions disagree about a
/// position close to the surface, and the surface computed from the points is closed.
class BrickSigns {
 public:
  void take(const BricksAround& around, float cell);
  std::uint32_t column(int x, int y) const { return columns_[std::size_t(y * signs_edge + x)]; }
  bool at(int x, int y, int z) const { return (column(x, y) >> z & 1) != 0; }
  /// Returns one bit for each corner of the cell whose lowest corner is x, y, z. The corners are numbered as in stock/surface/sheets.h.
  unsigned corners(int x, int y, int z) const {
    const auto two = [&](int i, int j) { return column(i, j) >> z & 3; };
    const unsigned a = two(x, y), b = two(x + 1, y), c = two(x, y + 1), d = two(x + 1, y + 1);
    return (a & 1) | (b & 1) << 1 | (c & 1) << 2 | (d & 1) << 3 | (a & 2) << 3 | (b & 2) << 4 | (c & 2) << 5 | (d & 2) << 6;
  }

 private:
  std::array<std::uint32_t, std::size_t(signs_edge) * signs_edge> columns_;
};

/// Returns true if a lattice point, given by its indices from the lattice's corner, is material.
bool is_material(const Stock& stock, const std::array<int, 3>& point);

}  // namespace kadr
