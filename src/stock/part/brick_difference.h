#pragma once
// Segments of a brick's lattice lines that are material but not part, or part but not material. Used by stock/part/part_compare.

#include <array>
#include <cstdint>
#include <vector>

#include "stock/part/part_lines.h"
#include "stock/stock.h"

namespace kadr {

/// A segment of a line, from the brick's corner, mm.
struct Stretch {
  std::int32_t line;
  double from, to;
  std::int32_t from_by, to_by;  // sweeps that made the material's end on that side; of_blank if none did
};

struct LineDifference {
  std::vector<Stretch> left_on, gouged;
};

/// Buffers of a thread, reused from brick to brick.
struct BrickDifference {
  std::array<LineDifference, 3> family;
  std::vector<LineRange> part;
  std::vector<Stretch> material;
};

/// The position of a brick in the lattice of the part's lines.
struct BrickAt {
  BrickPlace place;
  Vec3 corner;  // in the work system
  double cell;
};

/// Computes the differences in a brick. `brick` is a brick of the stock; nullptr if it is full (`is_full`) or empty.
void take_difference(const Brick* brick, bool is_full, const PartLines& part, const BrickAt& at, BrickDifference& difference);

}  // namespace kadr
