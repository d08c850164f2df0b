#pragma once
// Compares two stocks bit by bit.

#include <algorithm>
#include <cstring>

#include "stock/stock.h"

namespace kadr {

inline bool same_further(const FurtherInterval& a, const FurtherInterval& b) {
  return a.line == b.line && a.from == b.from && a.to == b.to && a.from_by == b.from_by && a.to_by == b.to_by;
}

inline bool same_lines(const BrickLines& a, const BrickLines& b) {
  return std::memcmp(a.from, b.from, sizeof a.from) == 0 && std::memcmp(a.to, b.to, sizeof a.to) == 0 &&
         std::memcmp(a.from_by, b.from_by, sizeof a.from_by) == 0 && std::memcmp(a.to_by, b.to_by, sizeof a.to_by) == 0 &&
         std::equal(a.further.begin(), a.further.end(), b.further.begin(), b.further.end(), same_further);
}

inline bool same_brick(const Brick* a, const Brick* b) {
  if (a == nullptr || b == nullptr) return a == b;
  return same_lines(a->family[0], b->family[0]) && same_lines(a->family[1], b->family[1]) && same_lines(a->family[2], b->family[2]);
}

inline bool same(const Stock& a, const Stock& b) {
  for (std::size_t i = 0; i < a.lattice().size(); ++i)
    if (a.state(i) != b.state(i) || !same_brick(a.brick(i), b.brick(i))) return false;
  return true;
}

}  // namespace kadr
