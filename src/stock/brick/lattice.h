#pragma once
// Lattice: the positions of the lattice points of a stock, and of the bricks (cubes of 16 × 16 × 16 points) into which they are grouped.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/vec.h"
#include "stock/brick/brick.h"

namespace kadr {

inline double along(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
inline double& along(Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

struct Box3 {
  Vec3 least, most;

  void include(const Box3& other) {
    for (int d = 0; d < 3; ++d) {
      along(least, d) = std::min(along(least, d), along(other.least, d));
      along(most, d) = std::max(along(most, d), along(other.most, d));
    }
  }
};

struct BrickPlace {
  int x = 0, y = 0, z = 0;
};

/// The box around the blank is divided into cubic cells, and a lattice point is in the middle of each cell. One empty layer of cells is
/// added around the box, and more layers to complete the last bricks.
class Lattice {
 public:
  Lattice(const Box3& box, double cell) : cell_(cell) {
    for (int d = 0; d < 3; ++d) {
      along(origin_, d) = along(box.least, d) - cell;
      bricks_[std::size_t(d)] = bricks_for(along(box.most, d) - along(box.least, d), cell);
    }
  }

  double cell() const { return cell_; }
  double edge() const { return cell_ * brick_edge; }  // edge length of a brick, mm
  const Vec3& origin() const { return origin_; }
  std::size_t size() const { return std::size_t(bricks_[0]) * std::size_t(bricks_[1]) * std::size_t(bricks_[2]); }
  int bricks(int axis) const { return bricks_[std::size_t(axis)]; }
  std::size_t at(BrickPlace p) const {
    return (std::size_t(p.z) * std::size_t(bricks_[1]) + std::size_t(p.y)) * std::size_t(bricks_[0]) + std::size_t(p.x);
  }
  BrickPlace place(std::size_t i) const {
    const std::size_t x = std::size_t(bricks_[0]), y = std::size_t(bricks_[1]);
    return {int(i % x), int(i / x % y), int(i / x / y)};
  }
  bool holds(BrickPlace p) const { return p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < bricks_[0] && p.y < bricks_[1] && p.z < bricks_[2]; }
  Vec3 corner(BrickPlace p) const { return origin_ + edge() * Vec3{double(p.x), double(p.y), double(p.z)}; }
  Vec3 corner(std::size_t i) const { return corner(place(i)); }

  /// Returns the number of bricks that are needed along an axis for a box of this length in mm.
  static int bricks_for(double length, double cell) { return int(std::ceil((length / cell + 4) / brick_edge)); }

 private:
  Vec3 origin_;
  double cell_;
  std::array<int, 3> bricks_{};
};

}  // namespace kadr
