#pragma once
// Lattice: the positions of the lattice points of a stock, and of the bricks (cubes of 16 × 16 × 16 points) into which they are grouped.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

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

/// A box of bricks: from `first` up to, and without, `end`.
struct BrickBox {
  std::array<int, 3> first{}, end{};

  bool holds(BrickPlace p) const {
    return p.x >= first[0] && p.y >= first[1] && p.z >= first[2] && p.x < end[0] && p.y < end[1] && p.z < end[2];
  }
};

/// The box around the blank is divided into cubic cells, and a lattice point is in the middle of each cell. One empty layer of cells is
/// added around the box, and more layers to complete the last bricks. A lattice may hold only a box of its bricks (held_only()): these
/// have the same places and corners, and only these have an index.
class Lattice {
 public:
  Lattice(const Box3& box, double cell) : cell_(cell) {
    for (int d = 0; d < 3; ++d) {
      along(origin_, d) = along(box.least, d) - cell;
      bricks_[std::size_t(d)] = bricks_for(along(box.most, d) - along(box.least, d), cell);
    }
    held_.end = bricks_;
  }

  /// Returns the same lattice, which holds only the bricks in the box.
  Lattice held_only(const BrickBox& box) const {
    Lattice some = *this;
    some.held_ = box;
    return some;
  }

  double cell() const { return cell_; }
  double edge() const { return cell_ * brick_edge; }  // edge length of a brick, mm
  const Vec3& origin() const { return origin_; }
  /// Returns the number of bricks that the lattice holds.
  std::size_t size() const { return across(0) * across(1) * across(2); }
  /// Returns the number of bricks along an axis, whether the lattice holds them or not.
  int bricks(int axis) const { return bricks_[std::size_t(axis)]; }
  const BrickBox& held() const { return held_; }
  /// Returns the first, and the last, place along an axis of the bricks that the lattice holds.
  int first(int axis) const { return held_.first[std::size_t(axis)]; }
  int last(int axis) const { return held_.end[std::size_t(axis)] - 1; }
  std::size_t at(BrickPlace p) const {
    return (std::size_t(p.z - first(2)) * across(1) + std::size_t(p.y - first(1))) * across(0) + std::size_t(p.x - first(0));
  }
  BrickPlace place(std::size_t i) const {
    const std::size_t x = across(0), y = across(1);
    return {int(i % x) + first(0), int(i / x % y) + first(1), int(i / x / y) + first(2)};
  }
  bool holds(BrickPlace p) const { return held_.holds(p); }
  /// Returns the number of a brick among all bricks of the lattice; it is the index of the brick if the lattice holds all.
  std::uint64_t number(BrickPlace p) const {
    return (std::uint64_t(p.z) * std::uint64_t(bricks_[1]) + std::uint64_t(p.y)) * std::uint64_t(bricks_[0]) + std::uint64_t(p.x);
  }
  Vec3 corner(BrickPlace p) const { return origin_ + edge() * Vec3{double(p.x), double(p.y), double(p.z)}; }
  Vec3 corner(std::size_t i) const { return corner(place(i)); }

  /// Returns the number of bricks that are needed along an axis for a box of this length in mm.
  static int bricks_for(double length, double cell) { return int(std::ceil((length / cell + 4) / brick_edge)); }

 private:
  std::size_t across(int axis) const { return std::size_t(std::max(last(axis) + 1 - first(axis), 0)); }

  Vec3 origin_;
  double cell_;
  std::array<int, 3> bricks_{};
  BrickBox held_;
};

}  // namespace kadr
