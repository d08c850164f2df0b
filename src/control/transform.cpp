#include <algorithm>

#include "control/state.h"

namespace kadr {

Transform::Transform() {
  scale.fill(1);
  added.fill(0);
  mirror.fill(1);
}

void Transform::refresh() {
  const auto is_one = [](double x) { return x == 1; };
  identity = rotation == 0 && std::all_of(scale.begin(), scale.end(), is_one) &&
             std::all_of(mirror.begin(), mirror.end(), [](std::int8_t m) { return m == 1; }) &&
             std::all_of(added.begin(), added.end(), [](double x) { return x == 0; });
}

bool Transform::reverses(const PlaneAxes& plane) const {
  return scale[plane.first] * mirror[plane.first] * scale[plane.second] * mirror[plane.second] < 0;
}

Axes Transform::to_work(const Axes& programmed) const {
  Axes work;
  for (std::size_t a = 0; a < max_axes; ++a) work[a] = programmed[a] * scale[a] * mirror[a];
  if (rotation != 0) {
    const Vec2 turned = rotation_center + rotated(Vec2{work[0], work[1]} - rotation_center, rotation);
    work[0] = turned.x;
    work[1] = turned.y;
  }
  for (std::size_t a = 0; a < max_axes; ++a) work[a] += added[a];
  return work;
}

Axes Transform::to_programmed(const Axes& work) const {
  Axes p;
  for (std::size_t a = 0; a < max_axes; ++a) p[a] = work[a] - added[a];
  if (rotation != 0) {
    const Vec2 back = rotation_center + rotated(Vec2{p[0], p[1]} - rotation_center, -rotation);
    p[0] = back.x;
    p[1] = back.y;
  }
  for (std::size_t a = 0; a < max_axes; ++a) p[a] = p[a] / scale[a] * mirror[a];
  return p;
}

}  // namespace kadr
