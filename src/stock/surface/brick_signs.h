#pragma once
// Which lattice points of a brick, and of the next layer beyond it, are material. For stock/surface.

#include <array>
#include <cstdint>

#include "stock/stock.h"

namespace kadr {

inline constexpr int signs_edge = brick_edge + 1;

/// A brick and the seven beside it in the direction of the axes: 1 along X, 2 along Y, 4 along Z. Beyond the lattice all is empty.
struct BricksAround {
  BricksAround(const Stock& stock, BrickPlace place);
  std::array<Stock::State, 8> state;
  std::array<const Brick*, 8> brick;
  bool same;  // all of them empty, or all full: no surface
};

/// A bit for each lattice point of a column, the lowest first. By the upright lines alone: so the signs of a point are one, whatever the
/// other families make of a place at the very surface, and the surface is closed.
class BrickSigns {
 public:
  void take(const BricksAround& around, float cell);
  std::uint32_t column(int x, int y) const { return columns_[std::size_t(y * signs_edge + x)]; }
  bool at(int x, int y, int z) const { return (column(x, y) >> z & 1) != 0; }
  /// Of the cell whose lowest corner that is, a bit for each corner (stock/surface/sheets.h).
  unsigned corners(int x, int y, int z) const {
    const auto two = [&](int i, int j) { return column(i, j) >> z & 3; };
    const unsigned a = two(x, y), b = two(x + 1, y), c = two(x, y + 1), d = two(x + 1, y + 1);
    return (a & 1) | (b & 1) << 1 | (c & 1) << 2 | (d & 1) << 3 | (a & 2) << 3 | (b & 2) << 4 | (c & 2) << 5 | (d & 2) << 6;
  }

 private:
  std::array<std::uint32_t, std::size_t(signs_edge) * signs_edge> columns_;
};

/// A lattice point, counted from the lattice's corner.
bool is_material(const Stock& stock, const std::array<int, 3>& point);

}  // namespace kadr
