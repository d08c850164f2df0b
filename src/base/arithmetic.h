#pragma once
// Short arithmetic functions that <cmath> lacks.

#include <limits>

namespace kadr {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

constexpr double square(double x) { return x * x; }

}  // namespace kadr
