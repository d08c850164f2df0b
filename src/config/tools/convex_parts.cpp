// Decomposes a polygon into convex parts by ear clipping. Used by config/tools/insert_keys, stock/tool/insert_shape.

#include "config/tools/convex_parts.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr double same_line = 1e-9;  // three points are collinear if twice the area of their triangle is less than this number of mm²

/// Returns twice the area of a triangle in mm², positive if its corners are in counter-clockwise order.
double turn(const InsertPoint& a, const InsertPoint& b, const InsertPoint& c) {
  return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
}

double twice_area(const InsertOutline& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += p[i].x * p[(i + 1) % p.size()].z - p[(i + 1) % p.size()].x * p[i].z;
  return sum;
}

bool touch(const InsertPoint& a, const InsertPoint& b, const InsertPoint& c, const InsertPoint& d) {
  const bool apart = std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
                     std::max(a.z, b.z) < std::min(c.z, d.z) || std::max(c.z, d.z) < std::min(a.z, b.z);
  const auto on_one_side = [](double u, double v) { return (u > 0 && v > 0) || (u < 0 && v < 0); };
  return !apart && !on_one_side(turn(a, b, c), turn(a, b, d)) && !on_one_side(turn(c, d, a), turn(c, d, b));
}

bool crosses_itself(const InsertOutline& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && touch(p[i], p[i + 1], p[j], p[(j + 1) % n])) return true;
  return false;
}

/// Removes corners that lie on the line between their neighbours.
void drop_straight_corners(InsertOutline& p) {
  for (std::size_t i = 0; p.size() >= 3 && i < p.size();) {
    const std::size_t n = p.size();
    if (std::fabs(turn(p[(i + n - 1) % n], p[i], p[(i + 1) % n])) > same_line) ++i;
    else p.erase(p.begin() + std::ptrdiff_t(i)), i = 0;
  }
}

bool is_convex(const InsertOutline& p) {
  for (std::size_t i = 0; i < p.size(); ++i)
    if (turn(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]) <= 0) return false;
  return true;
}

/// Returns true if the triangle of a corner and its neighbours lies inside the polygon and contains no other corner.
bool is_ear(const InsertOutline& p, std::size_t at) {
  const std::size_t n = p.size();
  const InsertPoint &a = p[(at + n - 1) % n], &b = p[at], &c = p[(at + 1) % n];
  if (turn(a, b, c) <= 0) return false;
  return std::none_of(p.begin(), p.end(), [&](const InsertPoint& q) {
    return !(q == a || q == b || q == c) && turn(a, b, q) >= 0 && turn(b, c, q) >= 0 && turn(c, a, q) >= 0;
  });
}

}  // namespace

std::vector<InsertOutline> convex_parts(InsertOutline p) {
  if (p.size() == 2) p = {p[0], {p[1].x, p[0].z}, p[1], {p[0].x, p[1].z}};
  drop_straight_corners(p);
  if (p.size() < 3 || crosses_itself(p)) return {};
  if (twice_area(p) < 0) std::reverse(p.begin(), p.end());
  std::vector<InsertOutline> parts;
  while (!is_convex(p)) {
    std::size_t at = 0;
    while (at < p.size() && !is_ear(p, at)) ++at;
    if (at == p.size()) return {};
    parts.push_back({p[(at + p.size() - 1) % p.size()], p[at], p[(at + 1) % p.size()]});
    p.erase(p.begin() + std::ptrdiff_t(at));
    drop_straight_corners(p);
    if (p.size() < 3) return parts;
  }
  parts.push_back(std::move(p));
  return parts;
}

}  // namespace kadr
