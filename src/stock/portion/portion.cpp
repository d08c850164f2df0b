// Divides the bricks of a lattice into portions. Used by cli/cut_portion.

#include "stock/portion/portion.h"

#include <algorithm>
#include <cstdint>

namespace kadr {

BrickBox bricks_of(const Lattice& lattice, Portion portion) {
  std::array<int, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return lattice.bricks(a) > lattice.bricks(b); });
  const auto [u, v, w] = axes;
  // Among all divisions into `rows` × `columns`, the one with the smallest area between the portions has the fewest bricks that are cut
  // twice.
  std::int64_t rows = 1, least = INT64_MAX;
  for (std::int64_t r = 1; r <= portion.count; ++r) {
    if (portion.count % r != 0) continue;
    const std::int64_t between = (r - 1) * lattice.bricks(u) + (portion.count / r - 1) * lattice.bricks(v);
    if (between < least) least = between, rows = r;
  }
  const std::int64_t columns = portion.count / rows, row = (portion.number - 1) / columns, column = (portion.number - 1) % columns;
  const auto share = [](std::int64_t bricks, std::int64_t i, std::int64_t parts) { return int(bricks * i / parts); };
  BrickBox box = lattice.held();
  box.first[std::size_t(u)] = share(lattice.bricks(u), column, columns),
  box.end[std::size_t(u)] = share(lattice.bricks(u), column + 1, columns);
  box.first[std::size_t(v)] = share(lattice.bricks(v), row, rows), box.end[std::size_t(v)] = share(lattice.bricks(v), row + 1, rows);
  for (std::size_t d = 0; d < 3; ++d)
    if (box.end[d] <= box.first[d]) return no_bricks;
  return box;
}

BrickBox with_neighbours(const BrickBox& box, const BrickBox& all) {
  BrickBox wider = box;
  for (std::size_t d = 0; d < 3; ++d) {
    if (box.end[d] <= box.first[d]) return box;
    wider.first[d] = std::max(box.first[d] - 1, all.first[d]), wider.end[d] = std::min(box.end[d] + 1, all.end[d]);
  }
  return wider;
}

}  // namespace kadr
