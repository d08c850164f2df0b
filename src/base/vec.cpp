// Small vectors, and trigonometry in degrees that is exact at multiples of 90°. Used by action, config, control, lang, machine, motion,
// out, path; tested by tests/base/vec_test.cpp.

#include "base/vec.h"

#include <cmath>
#include <cstdint>

namespace kadr {
namespace {

constexpr double root_half = 0.70710678118654752440;

/// Faster equivalent of std::remquo(deg, 90, &quarter). Returns `deg` reduced to [-45, 45], and sets `quarter` to the number of quarter
/// turns subtracted, modulo 4. The result is exact too: up to `most` degrees, neither the product of 90 and the number of quarter turns nor
/// the difference is rounded, because that number has few digits. At ±45°, either of the two neighbouring quarters may result.
double beyond_quarters(double deg, int& quarter) {
  // most: greatest angle in degrees that this function reduces itself; to_whole: adding and then subtracting it rounds a number to a whole
  // number
  constexpr double most = 1e12, to_whole = 0x1.8p52;
  if (!(std::fabs(deg) < most)) return std::remquo(deg, 90.0, &quarter);
  double quarters = (deg / 90 + to_whole) - to_whole;
  double rest = deg - quarters * 90;
  if (std::fabs(rest) > 45) {  // the quotient's rounding error had led to the neighbouring quarter, so the angle is corrected by 90°
    const double one = std::copysign(1.0, rest);
    quarters += one;
    rest -= one * 90;
  }
  quarter = static_cast<int>(static_cast<std::int64_t>(quarters) & 3);
  return rest == 0 ? std::copysign(0.0, deg) : rest;
}

}  // namespace

SinCos sincos_deg(double deg) {
  int quarter = 0;
  // The angle is reduced before the quarter is added, because the sum deg + 90 would be rounded.
  const double rest_deg = beyond_quarters(deg, quarter);
  const double rest = rest_deg * rad_per_deg;
  // at exactly ±45°, the result must be the same whether the angle was reduced to one quarter or to its neighbour
  const bool middle = std::fabs(rest_deg) == 45;
  const double s = middle ? std::copysign(root_half, rest) : std::sin(rest);
  const double c = middle ? root_half : std::cos(rest);
  switch (quarter & 3) {
    case 0: return {s, c};
    case 1: return {c, -s};
    case 2: return {-s, -c};
    default: return {-c, s};
  }
}

Vec2 rotated(Vec2 v, double deg) {
  const SinCos turn = sincos_deg(deg);
  return {v.x * turn.cos - v.y * turn.sin, v.x * turn.sin + v.y * turn.cos};
}

double angle_deg(Vec2 v) {
  if (v.y == 0) return v.x < 0 ? 180.0 : 0.0;
  if (v.x == 0) return v.y < 0 ? -90.0 : 90.0;
  const double angle = std::atan2(v.y, v.x) / rad_per_deg;
  return angle > -180 ? angle : 180.0;
}

}  // namespace kadr
