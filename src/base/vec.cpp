#include "base/vec.h"

namespace kadr {

SinCos sincos_deg(double deg) {
  int quarter = 0;
  const double rest = std::remquo(deg, 90.0, &quarter) * rad_per_deg;  // remquo is exact; deg + 90 would round
  const double s = std::sin(rest);
  const double c = std::cos(rest);
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
  return std::atan2(v.y, v.x) / rad_per_deg;
}

}  // namespace kadr
