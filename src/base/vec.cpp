// Small vectors and exact trigonometry in degrees. For action, config, control, lang, machine, motion, out, path; tested by
// tests/base/vec_test.cpp.

#include "base/vec.h"

namespace kadr {
namespace {

constexpr double root_half = 0.70710678118654752440;

}  // namespace

SinCos sincos_deg(double deg) {
  int quarter = 0;
  const double rest_deg = std::remquo(deg, 90.0, &quarter);  // remquo is exact; deg + 90 would round
  const double rest = rest_deg * rad_per_deg;
  const bool middle = std::fabs(rest_deg) == 45;  // either neighbour may be the nearest quarter: both must give the same
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
