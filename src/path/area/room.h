#pragma once
// Room: an area prepared for the question, asked of every move, whether a line stays in it.

#include "path/area/polygon.h"

namespace kadr::area {

class Room {
 public:
  Room() = default;
  explicit Room(Polygons area);

  const Polygons& area() const { return area_; }
  bool empty() const { return area_.empty(); }

  /// The line begins inside and meets no side of the boundary.
  bool surely_holds(const Polygon& line) const;
  /// No stretch of the line that is outside has chords longer than `most` mm.
  bool holds(const Polygon& line, double most) const;

 private:
  struct Side {
    Vec2 a, b;
  };
  std::size_t column(double x) const;
  std::size_t row(double y) const;
  /// Calls `take(cell)` for the cells that the line from a to b goes through, until it returns true.
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
