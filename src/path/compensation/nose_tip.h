#pragma once
// nose_vector() gives the position of the imaginary tip of a turning tool. A turning tool has a round nose. Its offsets are measured to the
// imaginary tip: the corner of the axis-parallel lines that touch the nose, or the point at which one such line touches the nose.
//
//   second axis (X)
//     ▲    2  6  1
//     │    7  ○  5      each number is drawn at the position of the tip relative to the nose centre ○ (0, 9)
//     │    3  8  4
//     └──────────► first axis (Z)

#include <array>
#include <cstdint>

#include "base/vec.h"

namespace kadr {

/// Returns the vector from the nose centre to the imaginary tip.
///   nose     number of the tip; 0, 9 and numbers above 9: the tip is the nose centre
///   radius   nose radius, mm, not negative
///   returns  mm, in the first and second axis of the plane: (Z, X) in the plane ZX
///   law      each component is -radius, 0 or radius
///   manual   fanuc-t 7.1, nct 15.1 (the column Q)
inline Vec2 nose_vector(std::uint8_t nose, double radius) {
  constexpr std::array<Vec2, 9> tips{{{0, 0}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  return nose < tips.size() ? radius * tips[nose] : Vec2{};
}

}  // namespace kadr
