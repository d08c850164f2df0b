// Measures the radii of the material along a lattice line. Used by session/cutting/thread_cuts; tested by tests/stock/turn_test.cpp.

#include "stock/material_around.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace kadr {
namespace {

constexpr double one_piece = 1e-4;  // limit in mm: intervals of neighbouring bricks with a smaller gap count as one interval

/// Returns the index, counted through all bricks, of the lattice line nearest to a position along the axis; nullopt if the position is more
/// than one cell outside the lattice.
std::optional<int> nearest_line(const Lattice& lattice, double from_corner, int axis) {
  const int lines = lattice.bricks(axis) * brick_edge, nearest = int(std::floor(from_corner / lattice.cell()));
  if (nearest < -1 || nearest > lines) return std::nullopt;
  return std::clamp(nearest, 0, lines - 1);
}

void add_pieces(const Stock& stock, std::size_t b, int line, std::vector<LineRange>& pieces) {
  const double corner = stock.lattice().corner(b).x;
  const Brick* const brick = stock.brick(b);
  if (brick == nullptr) {
    if (stock.state(b) == Stock::State::full) pieces.push_back({corner, corner + stock.lattice().edge()});
    return;
  }
  const BrickLines& lines = brick->family[0];
  const auto add = [&](float from, float to) {
    if (from < to) pieces.push_back({corner + double(from), corner + double(to)});
  };
  add(lines.from[line], lines.to[line]);
  for (const FurtherInterval& f : lines.further)
    if (f.line == line) add(f.from, f.to);
}

}  // namespace

std::optional<RadiusRange> material_around(const Stock& stock, double radius, double z) {
  const Lattice& lattice = stock.lattice();
  const std::optional<int> row = nearest_line(lattice, -lattice.origin().y, 1), level = nearest_line(lattice, z - lattice.origin().z, 2);
  if (!row || !level) return std::nullopt;
  const double row_y = lattice.origin().y + (*row + 0.5) * lattice.cell();
  std::vector<LineRange> pieces;
  for (int x = 0; x < lattice.bricks(0); ++x)
    add_pieces(stock, lattice.at({x, *row / brick_edge, *level / brick_edge}), *level % brick_edge * brick_edge + *row % brick_edge,
               pieces);
  std::sort(pieces.begin(), pieces.end(), [](const LineRange& a, const LineRange& b) { return a.from < b.from; });
  const double at = std::sqrt(std::max(radius * radius - row_y * row_y, 0.0));
  std::optional<LineRange> found;
  for (const LineRange& piece : pieces) {
    if (found && piece.from - found->to < one_piece) found->to = std::max(found->to, piece.to);
    else if (found && found->to >= at) break;
    else found = piece;
  }
  if (!found || found->from > at || found->to < at) return std::nullopt;
  return RadiusRange{found->from > 0 ? std::hypot(found->from, row_y) : 0.0, std::hypot(found->to, row_y)};
}

}  // namespace kadr
