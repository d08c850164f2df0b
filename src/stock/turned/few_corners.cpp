// Simplifies polygons of the half plane. Used by stock/turned; tested by tests/stock/turned_stock_test.cpp.

#include "stock/turned/few_corners.h"

#include <algorithm>

#include "stock/turned/edge_distance.h"

namespace kadr {
namespace {

/// Marks the corners between two others that a polyline within `deviation` mm needs. `last` may be one past the end: the first corner.
void mark_needed(const TurnedPolygon& p, std::size_t first, std::size_t last, double deviation, std::vector<bool>& needed) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    double most = deviation;
    std::size_t farthest = a;
    for (std::size_t i = a + 1; i < b; ++i)
      if (const double off = distance_to_edge(p[i], p[a], p[b % p.size()]); off > most) most = off, farthest = i;
    if (farthest == a) continue;
    needed[farthest] = true;
    open.push_back({a, farthest});
    open.push_back({farthest, b});
  }
}

}  // namespace

std::vector<bool> needed_corners(const TurnedPolygon& p, const std::vector<bool>& fixed, double deviation) {
  std::vector<bool> needed = fixed.empty() ? std::vector<bool>(p.size()) : fixed;
  if (p.size() < 2) return needed;
  std::size_t opposite = 0;
  for (std::size_t i = 1; i < p.size(); ++i)
    if (length(p[i] - p[0]) > length(p[opposite] - p[0])) opposite = i;
  needed[0] = needed[opposite] = true;
  std::size_t from = 0;
  for (std::size_t i = 1; i <= p.size(); ++i) {
    if (i < p.size() && !needed[i]) continue;
    std::vector<bool> between(p.size());
    mark_needed(p, from, i, deviation, between);
    for (std::size_t k = from + 1; k < i; ++k)
      if (between[k]) needed[k] = true;
    from = i;
  }
  return needed;
}

}  // namespace kadr
