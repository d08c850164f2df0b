#pragma once
// Stretches of the lattice lines in a brick that are material and not part, or part and not material. For stock/part/part_compare.

#include <array>
#include <cstdint>
#include <vector>

#include "stock/part/part_lines.h"
#include "stock/stock.h"

namespace kadr {

/// On a line, from the brick's corner, mm.
struct Stretch {
  std::int32_t line;
  double from, to;
  std::int32_t from_by, to_by;  // sweeps that made the material's ends there; of_blank
};

struct LineDifference {
  std::vector<Stretch> left_on, gouged;
};

/// What a thread needs, kept from brick to brick.
struct BrickDifference {
  std::array<LineDifference, 3> family;
  std::vector<LineRange> part;
  std::vector<Stretch> material;
};

/// Where it is, in the lattice of the part's lines.
struct BrickAt {
  BrickPlace place;
  Vec3 corner;  // in the work system
  double cell;
};

/// `brick`: of the stock; nullptr: it is all material, or none.
void take_difference(const Brick* brick, bool is_full, const PartLines& part, const BrickAt& at, BrickDifference& difference);

}  // namespace kadr
