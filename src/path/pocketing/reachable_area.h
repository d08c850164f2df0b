#pragma once
// Room is an area that is prepared for a fast test whether a polyline stays inside the area. Every move of a path is tested.

#include "path/pocketing/polygon.h"

namespace kadr::area {

class Room {
 public:
  Room() = default;
  explicit Room(Polygons area);

  const Polygons& area() const { return area_; }
  bool empty() const { return area_.empty(); }

  /// Returns true if the polyline starts inside the area and does not meet the boundary.
  bool surely_holds(const Polygon& line) const;
  /// Returns true if each part of the polyline outside the area is at most `most` mm long.
  bool holds(const Polygon& line, double most) const;

 private:
  struct Side {
    Vec2 a, b;
  };
  std::size_t column(double x) const;
  std::size_t row(double y) const;
  /// Calls `take(cell)` for each grid cell through which the line from `a` to `b` passes, until a call returns true. Returns true if a call
  /// returned true.
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
