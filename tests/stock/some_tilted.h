#pragma once
// Random paths of tilted tools, for the tests of the cut.

#include "stock/some_tools.h"

namespace kadr {

inline Vec3 some_direction(Chance& chance) {
  const double lean = chance.below(3) == 0 ? 180 : 60, a = chance.between(0, lean) * rad_per_deg, b = chance.between(0, 360) * rad_per_deg;
  switch (chance.below(8)) {
    case 0: return {1, 0, 0};
    case 1: return {0, -1, 0};
    case 2: return {std::sin(a), 0, std::cos(a)};
    case 3: return {0, 1e-5, std::sqrt(1 - 1e-10)};
    default: return {std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
  }
}

/// Returns a direction turned by an angle from a tenth of the least turn up to a right angle, or not turned.
inline Vec3 some_turn(Vec3 direction, Chance& chance) {
  if (chance.below(4) == 0) return direction;
  const Vec3 away{chance.between(-1, 1), chance.between(-1, 1), chance.between(-1, 1)};
  const Vec3 turned = direction + std::pow(10, chance.between(-4, 0)) * away;
  return (1 / length(turned)) * turned;
}

inline Sweep some_tilted_move(Chance& chance) {
  Sweep sweep = some_move(chance);
  const double far = length(sweep.to - sweep.from);
  if (far > 60) sweep.to = sweep.from + (60 / far) * (sweep.to - sweep.from);
  if (chance.below(12) == 0) sweep.to = sweep.from;
  sweep.from_direction = some_direction(chance), sweep.to_direction = some_turn(sweep.from_direction, chance);
  return sweep;
}

}  // namespace kadr
