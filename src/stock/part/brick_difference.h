#pragma once
// Compares the material in a brick with the wanted part, line by line. Finds the segments of lattice lines that are in only one of the two.
// Used by stock/part/part_compare.

#include <array>
#include <cstdint>
#include <vector>

#include "stock/part/part_lines.h"
#include "stock/stock.h"

namespace kadr {

/// A segment of a lattice line, in mm from the brick's corner.
struct LineSegment {
  std::int32_t line;
  double from, to;
  std::int32_t from_by, to_by;  // the sweeps that cut the material at the two ends of the segment; of_blank where no sweep cut
};

struct LineDifference {
  std::vector<LineSegment> left_on, gouged;
};

/// Buffers of one thread, which are reused for each brick.
struct BrickDifference {
  std::array<LineDifference, 3> family;
  std::vector<LineRange> part;
  std::vector<LineSegment> material;
};

/// A brick of the lattice on whose lines the wanted part was computed.
struct BrickAt {
  BrickPlace place;
  Vec3 corner;  // corner of the brick in work coordinates, mm
  double cell;
};

/// Computes the differences in one brick. `brick` is the brick of the stock; nullptr if the brick is full (`is_full`) or empty.
void take_difference(const Brick* brick, bool is_full, const PartLines& part, const BrickAt& at, BrickDifference& difference);

}  // namespace kadr
