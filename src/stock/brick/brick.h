#pragma once
// Brick: what is left of the material in a cube of 16 by 16 by 16 lattice points, as intervals on its lattice lines.
//
// Through the points run lines in three directions, the families 0, 1, 2 (along X, Y, Z). A line of family f is numbered by its place along
// the axes u = (f + 1) % 3 (the lane) and v = (f + 2) % 3 (the row). On each lie intervals of material; each end of one knows the sweep
// that made it. Lengths mm, from the brick's corner.

#include <array>
#include <cstdint>
#include <vector>

namespace kadr {

inline constexpr int brick_edge = 16;
inline constexpr int brick_lines = brick_edge * brick_edge;  // of a family

inline constexpr std::int32_t of_blank = -1;  // an end that no sweep has made

/// A line with more than one interval.
struct FurtherInterval {
  std::int32_t line;
  float from, to;
  std::int32_t from_by, to_by;
};

/// The lines of one family. An interval whose end is not behind its beginning is none.
struct BrickLines {
  alignas(32) float from[brick_lines];
  alignas(32) float to[brick_lines];
  alignas(32) std::int32_t from_by[brick_lines];
  alignas(32) std::int32_t to_by[brick_lines];
  std::vector<FurtherInterval> further;
};

struct Brick {
  std::array<BrickLines, 3> family;
  // Bounds of what is left, so that a sweep above it is seen at once: over squares of four by four columns, and of all.
  alignas(32) std::array<float, 16> top_of_square;
  float top = 0;
  int cuts_since = 0;  // that the bounds were taken
};

/// Takes the bounds anew.
void take_tops(Brick& brick, float cell);

}  // namespace kadr
