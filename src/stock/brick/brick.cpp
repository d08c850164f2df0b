// Computes upper bounds of the height of the material in a brick. Used by stock/cut/brick_cut.

#include "stock/brick/brick.h"

#include <algorithm>

namespace kadr {
namespace {

constexpr int square_edge = 4, squares_along = brick_edge / square_edge;

/// Returns the height bound of the square of 4 × 4 lattice lines along Z that contains the line with the indices x, y.
float& square_of(Brick& brick, int x, int y) { return brick.top_of_square[std::size_t(y / square_edge * squares_along + x / square_edge)]; }

void raise(float& top, float to) { top = std::max(top, to); }

/// Raises the height bounds to the material between two positions of a line along X or Y (family 0 or 1). The material is at the height of
/// the lattice points of this line.
void raise_by_level_line(Brick& brick, int family, int line, float from, float to, float cell) {
  if (from >= to) return;
  const int lane = line % brick_edge, row = line / brick_edge;
  const int height = family == 0 ? row : lane, across = family == 0 ? lane : row;
  const float z = (float(height) + 0.5f) * cell;
  const int first = std::clamp(int(from / cell), 0, brick_edge - 1), last = std::clamp(int(to / cell), 0, brick_edge - 1);
  for (int at = first / square_edge * square_edge; at <= last; at += square_edge)
    raise(family == 0 ? square_of(brick, at, across) : square_of(brick, across, at), z);
}

void raise_by_upright_lines(Brick& brick) {
  const BrickLines& lines = brick.family[2];
  float column[brick_lines];
  for (int i = 0; i < brick_lines; ++i) column[i] = lines.from[i] < lines.to[i] ? lines.to[i] : -1.f;
  for (int i = 0; i < brick_lines; ++i) raise(square_of(brick, i % brick_edge, i / brick_edge), column[i]);
  for (const FurtherInterval& f : lines.further) raise(square_of(brick, f.line % brick_edge, f.line / brick_edge), f.to);
}

}  // namespace

void refresh_tops(Brick& brick, float cell) {
  brick.top_of_square.fill(-1.f);
  raise_by_upright_lines(brick);
  const float lowest = *std::min_element(brick.top_of_square.begin(), brick.top_of_square.end());
  for (int family = 0; family < 2; ++family) {
    const BrickLines& lines = brick.family[std::size_t(family)];
    for (int i = 0; i < brick_lines; ++i) {
      const int height = family == 0 ? i / brick_edge : i % brick_edge;
      if ((float(height) + 0.5f) * cell > lowest) raise_by_level_line(brick, family, i, lines.from[i], lines.to[i], cell);
    }
    for (const FurtherInterval& f : lines.further) raise_by_level_line(brick, family, f.line, f.from, f.to, cell);
  }
  brick.top = *std::max_element(brick.top_of_square.begin(), brick.top_of_square.end());
  brick.cuts_since = 0;
}

}  // namespace kadr
