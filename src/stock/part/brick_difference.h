#pragma once
// Stretches of the lattice lines in a brick that are material and not part, or part and not material. For stock/part/part_compare.

#include <array>
#include <cstdint>
#include <vector>

#include "stock/blank/blank.h"
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

/// `brick`: of the stock; nullptr: it is all material, or none. `corner`: in the work system.
void take_difference(const Brick* brick, bool is_full, const Blank& part, const Vec3& corner, double cell, BrickDifference& difference);

}  // namespace kadr
