#pragma once
// What both halves of motion/least_time need: the Bernstein polynomials of a cell's ordinates at the places where limits are looked at.

#include <array>

#include "motion/least_time.h"

namespace kadr::least_time {

inline constexpr auto weights = [] {
  std::array<std::array<double, TimedPath::places>, 3> w{};
  for (std::size_t p = 0; p < TimedPath::places; ++p) {
    const double part = TimedPath::part[p], rest = 1 - part;
    w[0][p] = rest * rest, w[1][p] = 2 * part * rest, w[2][p] = part * part;
  }
  return w;
}();

}  // namespace kadr::least_time
