#pragma once
// Brick: the remaining material in a cube of 16 × 16 × 16 lattice points, stored as intervals on the lattice lines through the points.
//
// The lines run in three directions, the families 0, 1, 2 (along X, Y, Z). A line of family f has a lane, its index along the axis
// u = (f + 1) % 3, and a row, its index along v = (f + 2) % 3; its number is 16 · row + lane. Each line has intervals of material, and
// for each end of an interval the number of the sweep that cut there. Lengths are in mm, from the brick's corner.

#include <array>
#include <cstdint>
#include <vector>

namespace kadr {

inline constexpr int brick_edge = 16;
inline constexpr int brick_lines = brick_edge * brick_edge;  // number of lattice lines in a family

// Number in place of a sweep's number, for an end of an interval that is on the blank's surface, where no sweep has cut.
inline constexpr std::int32_t of_blank = -1;

/// A second or later interval of a line.
struct FurtherInterval {
  std::int32_t line;
  float from, to;
  std::int32_t from_by, to_by;
};

/// The first interval of each line of one family, and the further intervals. An interval is empty if `to` is not greater than `from`.
struct BrickLines {
  alignas(32) float from[brick_lines];
  alignas(32) float to[brick_lines];
  alignas(32) std::int32_t from_by[brick_lines];
  alignas(32) std::int32_t to_by[brick_lines];
  std::vector<FurtherInterval> further;
};

struct Brick {
  std::array<BrickLines, 3> family;
  // Upper bounds of the height of the material, mm: one for each square of 4 × 4 lines along Z, and one for the whole brick. A sweep that
  // stays above a bound removes nothing there and is skipped.
  alignas(32) std::array<float, 16> top_of_square;
  float top = 0;
  int cuts_since = 0;  // number of cuts since the height bounds were last computed
};

/// Recomputes the height bounds `top_of_square` and `top`.
void refresh_tops(Brick& brick, float cell);

}  // namespace kadr
