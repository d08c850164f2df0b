#pragma once
// Finds the crossings: the points where the surface of the material crosses the edges of a brick's lattice cells. Used by stock/surface.

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "stock/surface/brick_signs.h"
#include "stock/surface/cut_normal.h"

namespace kadr {

/// A crossing of the surface with the edge of a lattice cell. Lengths are in mm, from the brick's corner.
struct Crossing {
  std::array<float, 3> at;
  std::array<float, 3> normal;  // outward normal of the material, a unit vector
  std::int32_t by;              // number of the sweep that cut this surface; of_blank for the surface of the blank
};

/// The edge of a lattice cell from the point with the indices `point` to the next point along the axis `family`.
struct LatticeEdge {
  int family;
  std::array<int, 3> point;
};

/// The crossings of all cell edges whose end points are in the brick or in the next layer of points beyond the brick.
class Crossings {
 public:
  Crossings();
  void take(const Stock& stock, const std::vector<ToolFaces>& tools, std::size_t brick, const BricksAround& around,
            const BrickSigns& signs);
  bool none() const { return all_.empty(); }
  const Crossing& of(const LatticeEdge& e) const { return all_[slots_[slot_of(e)]]; }

 private:
  struct Finder;
  static std::size_t slot_of(const LatticeEdge& e) {
    return std::size_t(((e.family * signs_edge + e.point[2]) * signs_edge + e.point[1]) * signs_edge + e.point[0]);
  }
  void mend(const LatticeEdge& e, const BrickSigns& signs);

  std::vector<Crossing> all_;
  std::vector<std::uint16_t> slots_;
  // Edges between material and air on whose lattice line no interval ends, so that the crossing must be estimated.
  std::vector<LatticeEdge> lost_;
};

/// Calls visit(edge, starts_in_material) for each cell edge with material at exactly one of the two end points. The indices of the point
/// across the edge go from 0 to `last`.
template <class Visit>
void each_unlike_edge(const BrickSigns& signs, int last, const Visit& visit) {
  for (int family = 0; family < 3; ++family) {
    const int x_end = family == 0 ? brick_edge : last + 1, y_end = family == 1 ? brick_edge : last + 1;
    const std::uint32_t all = family == 2 ? (1u << brick_edge) - 1 : (2u << last) - 1;
    for (int y = 0; y < y_end; ++y)
      for (int x = 0; x < x_end; ++x) {
        const std::uint32_t here = signs.column(x, y);
        const std::uint32_t next = family == 0 ? signs.column(x + 1, y) : family == 1 ? signs.column(x, y + 1) : here >> 1;
        for (std::uint32_t unlike = (here ^ next) & all; unlike != 0; unlike &= unlike - 1) {
          const int z = std::countr_zero(unlike);
          visit(LatticeEdge{family, {x, y, z}}, (here >> z & 1) != 0);
        }
      }
  }
}

}  // namespace kadr
