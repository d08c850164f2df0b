// Computes the rings by which milling cycles clear an area.

#include "control/cycles/pocket_rings.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"

namespace kadr {

RoundedRectangle RoundedRectangle::inset(double distance) const {
  return {half_length - distance, half_width - distance, std::max(0.0, corner - distance)};
}

bool RoundedRectangle::is_circle() const {
  return std::fabs(half_length - half_width) <= tol::same_point && std::fabs(corner - half_length) <= tol::same_point;
}

void append_ring(std::vector<RingMove>& moves, RoundedRectangle shape, bool clockwise) {
  const double a = shape.half_length, b = shape.half_width, c = shape.corner;
  if (a <= tol::same_point && b <= tol::same_point) return;
  if (shape.is_circle()) {
    moves.push_back({{a, 0}, {}, 0});
    moves.push_back({{a, 0}, {0, 0}, 1});
    return;
  }
  const double side = clockwise ? -1 : 1;  // counter-clockwise towards +X on the lower side
  moves.push_back({{0, -b}, {}, 0});
  const Vec2 around[] = {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  for (int i = 0; i < 4; ++i) {
    const Vec2 at{around[i].x * a * side, around[i].y * b};  // corner of the ring, mirrored for clockwise
    const Vec2 in = i % 2 == 0 ? Vec2{around[i].x * side * c, 0} : Vec2{0, around[i].y * c};
    const Vec2 out = i % 2 == 0 ? Vec2{0, around[i].y * c} : Vec2{around[i].x * side * c, 0};
    moves.push_back({at - in, {}, 0});
    if (c > tol::same_point) moves.push_back({at - out, at - in - out, 0.25});
  }
  moves.push_back({{0, -b}, {}, 0});
}

void append_rings(std::vector<RingMove>& moves, RoundedRectangle outer, double width, bool clockwise) {
  const double least = std::min(outer.half_length, outer.half_width);
  const auto count = static_cast<int>(std::ceil(least / width - 1e-9));
  for (int i = 0; i <= count; ++i) append_ring(moves, outer.inset(count == 0 ? 0 : least - least * i / count), clockwise);
  moves.push_back({{0, 0}, {}, 0});
}

}  // namespace kadr
