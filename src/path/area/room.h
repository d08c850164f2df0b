#pragma once
// Room: an area prepared for fast tests whether a line stays inside it; every move is tested.

#include "path/area/polygon.h"

namespace kadr::area {

class Room {
 public:
  Room() = default;
  explicit Room(Polygons area);

  const Polygons& area() const { return area_; }
  bool empty() const { return area_.empty(); }

  /// Returns true if the line starts inside and meets no side of the boundary.
  bool surely_holds(const Polygon& line) const;
  /// Returns true if no part of the line outside the area has chords longer than `most` mm.
  bool holds(const Polygon& line, double most) const;

 private:
  struct Side {
    Vec2 a, b;
  };
  std::size_t column(double x) const;
  std::size_t row(double y) const;
  /// Calls `take(cell)` for the cells that the line from a to b passes through, until it returns true.
  template <class Take>
  bool any_cell(Vec2 a, Vec2 b, Take take) const;
  bool meets_boundary(Vec2 a, Vec2 b) const;

  Polygons area_;
  Bounds box_;
  std::size_t across_ = 0;  // cells in each direction
  std::vector<Side> sides_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace kadr::area
