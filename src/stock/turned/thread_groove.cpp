// Computes the groove of a thread at a place of the part. Used by stock/turned/turned_surface; tested by
// tests/stock/turned_surface_test.cpp.

#include "stock/turned/thread_groove.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kadr {
namespace {

constexpr double no_groove = 1e9;  // mm; the radius of an outer groove where there is none

/// Returns the least and the greatest extent of the outline along Z.
Vec2 outline_reach(const TurnedPolygon& outline) {
  Vec2 reach{no_groove, -no_groove};
  for (const Vec2 p : outline) reach = {std::min(reach.x, p.y), std::max(reach.y, p.y)};
  return reach;
}

}  // namespace

std::optional<double> outline_at(const TurnedPolygon& outline, double z, bool least) {
  std::optional<double> best;
  const auto take = [&](double x) { best = !best ? x : least ? std::min(*best, x) : std::max(*best, x); };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    if (std::min(a.y, b.y) > z || std::max(a.y, b.y) < z) continue;
    if (a.y == b.y) take(a.x), take(b.x);
    else take(a.x + (b.x - a.x) * (z - a.y) / (b.y - a.y));
  }
  return best;
}

Vec2 ThreadGroove::reach() const {
  const Vec2 own = outline_reach(outline);
  return {std::min(from.y, to.y) + own.x, std::max(from.y, to.y) + own.y};
}

double ThreadGroove::radius(double angle, double z) const {
  const double low = std::min(from.y, to.y), high = std::max(from.y, to.y);
  const double turned = angle / (2 * std::numbers::pi) * (left_handed ? -1 : 1);
  const Vec2 own = outline_reach(outline);
  // The tips whose insert covers z: z - own.y <= tip <= z - own.x.
  const double first = std::max(low, z - own.y), last = std::min(high, z - own.x);
  double best = is_outer ? no_groove : -1;
  const double at = start + lead * turned;
  for (double k = std::ceil((first - at) / lead); at + k * lead <= last; ++k) {
    const double tip = at + k * lead;
    const double share = to.y != from.y ? (tip - from.y) / (to.y - from.y) : 0;
    const auto side = outline_at(outline, z - tip, is_outer);
    if (!side) continue;
    const double radius = from.x + share * (to.x - from.x) + *side;
    best = is_outer ? std::min(best, radius) : std::max(best, radius);
  }
  return best;
}

}  // namespace kadr
