#pragma once
// Brick: the remaining material in a cube of 16 by 16 by 16 lattice points, as intervals on its lattice lines.
//
// Lines run through the points in three directions, the families 0, 1, 2 (along X, Y, Z). The number of a line of family f comes from
// its position along the axes u = (f + 1) % 3 (the lane) and v = (f + 2) % 3 (the row). Each line holds intervals of material, and
// each end of an interval holds the number of the sweep that made it. Lengths are in mm, from the brick's corner.

#include <array>
#include <cstdint>
#include <vector>

namespace kadr {

inline constexpr int brick_edge = 16;
inline constexpr int brick_lines = brick_edge * brick_edge;  // of a family

inline constexpr std::int32_t of_blank = -1;  // marks an end that no sweep has made

/// An interval of a line beyond the line's first.
struct FurtherInterval {
  std::int32_t line;
  float from, to;
  std::int32_t from_by, to_by;
};

/// The lines of one family. An interval whose end is not greater than its beginning is empty.
struct BrickLines {
  alignas(32) float from[brick_lines];
  alignas(32) float to[brick_lines];
  alignas(32) std::int32_t from_by[brick_lines];
  alignas(32) std::int32_t to_by[brick_lines];
  std::vector<FurtherInterval> further;
};

struct Brick {
  std::array<BrickLines, 3> family;
  // Upper bounds of the material's height, which exclude sweeps above it quickly: for squares of four by four columns, and for the
  // brick.
  alignas(32) std::array<float, 16> top_of_square;
  float top = 0;
  int cuts_since = 0;  // number of cuts since the bounds were computed
};

/// Recomputes the bounds.
void take_tops(Brick& brick, float cell);

}  // namespace kadr
