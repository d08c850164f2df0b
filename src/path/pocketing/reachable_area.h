#pragma once
// Room: an area prepared for fast tests whether a polyline stays inside the area; every move of a path is tested.

#include "path/pocketing/polygon.h"

namespace kadr::area {

class Room {
 public:
  Room() = default;
  explicit Room(Polygons area);

  const Polygons& area() const { return area_; }
  bool empty() const { return area_.empty(); }

  /// Returns true if the polyline starts inside the area and meets no side of the boundary.
  bool surely_holds(const Polygon& line) const;
  /// Returns true if no part of the polyline outside the area is longer than `most` mm.
  bool holds(const Polygon& line, double most) const;

 private:
  struct Side {
    Vec2 a, b;
  };
  std::size_t column(double x) const;
  std::size_t row(double y) const;
  /// Calls `take(cell)` for each grid cell that the line from a to b passes through, until a call returns true. Returns true if a call did.
  template <class Take>
  bool any_cell(Vec2 a, Vec2 b, Take take) const;
  bool meets_boundary(Vec2 a, Vec2 b) const;

  Polygons area_;
  Bounds box_;
  std::size_t across_ = 0;  // number of grid cells in each direction
  std::vector<Side> sides_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace kadr::area
