#pragma once
// Points on lattice lines for the tests of the cut, and whether they are material.

#include <algorithm>

#include "stock/some_tools.h"

namespace kadr {

/// A point on a lattice line.
struct LinePosition {
  std::size_t brick;
  int family, line;
  Vec3 corner, at;      // corner of the brick; the point
  bool is_end = false;  // an end made by the sweep: on the surface of the swept volume
};

inline bool is_material(const Stock& stock, const LinePosition& p) {
  if (stock.brick(p.brick) == nullptr) return stock.state(p.brick) == Stock::State::full;
  const BrickLines& lines = stock.brick(p.brick)->family[std::size_t(p.family)];
  const double along_line = along(p.at, p.family) - along(p.corner, p.family);
  bool within = lines.from[p.line] < lines.to[p.line] && along_line >= double(lines.from[p.line]) && along_line <= double(lines.to[p.line]);
  for (const FurtherInterval& f : lines.further)
    within = within || (f.line == p.line && along_line >= double(f.from) && along_line <= double(f.to));
  return within;
}

/// Returns a point, mostly at or close to an end that the sweep has made, if the line has one.
inline LinePosition some_place(const Stock& stock, Chance& chance) {
  const Lattice& lattice = stock.lattice();
  const std::size_t brick = std::size_t(chance.below(int(lattice.size())));
  LinePosition p{brick, chance.below(3), chance.below(brick_lines), lattice.corner(brick), {}};
  p.at = p.corner;
  along(p.at, (p.family + 1) % 3) += (p.line % brick_edge + 0.5) * lattice.cell();
  along(p.at, (p.family + 2) % 3) += (p.line / brick_edge + 0.5) * lattice.cell();
  double from_corner = chance.between(0, lattice.edge());
  const double shift = chance.between(-0.01, 0.01);
  const int wanted = chance.below(3);
  if (const Brick* b = stock.brick(brick); b != nullptr && wanted != 0) {
    const BrickLines& lines = b->family[std::size_t(p.family)];
    const bool any = lines.from[p.line] < lines.to[p.line], from = any && lines.from_by[p.line] != of_blank,
               to = any && lines.to_by[p.line] != of_blank;
    p.is_end = wanted == 1 && (from || to);
    if (from || to) from_corner = double(from ? lines.from[p.line] : lines.to[p.line]) + (p.is_end ? 0 : shift);
  }
  along(p.at, p.family) += std::clamp(from_corner, 0.0, lattice.edge());
  return p;
}

inline bool within(const Box3& box, Vec3 at) {
  bool inside = true;
  for (int d = 0; d < 3; ++d) inside = inside && along(at, d) > along(box.least, d) && along(at, d) < along(box.most, d);
  return inside;
}

}  // namespace kadr
