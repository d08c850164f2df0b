// Makes the helical surface of threads. Used by stock/turned; tested by tests/stock/turned_surface_test.cpp, turned_picture_test.cpp.

#include "stock/turned/thread_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kadr {
namespace {

constexpr double least_groove = 1e-3;  // mm; a groove that is shallower is not drawn

}  // namespace

std::pair<double, std::int32_t> ThreadedPart::at(const ShownEdge& edge, double angle, double z) const {
  std::pair<double, std::int32_t> result{edge.radius(z), edge.maker};
  for (const ThreadGroove* const groove : grooves) {
    const double radius = std::max(groove->radius(angle, z), groove->is_outer ? 0.0 : -1.0);
    if (groove->is_outer ? radius < result.first - least_groove : radius > result.first + least_groove) result = {radius, groove->maker};
  }
  return result;
}

std::optional<ThreadedPart> threads_on(const ShownEdge& edge, const std::vector<ThreadGroove>& threads) {
  ThreadedPart part;
  part.low = edge.high(), part.high = edge.low();
  const auto deeper = [](const ThreadGroove* a, const ThreadGroove* b) {
    return a->is_outer ? a->from.x + a->to.x < b->from.x + b->to.x : a->from.x + a->to.x > b->from.x + b->to.x;
  };
  for (const ThreadGroove& groove : threads) {
    if (groove.is_outer != edge.is_outer() || edge.a.y == edge.b.y || !(groove.lead > 0)) continue;
    const Vec2 reach = groove.reach();
    const double low = std::max(edge.low(), reach.x), high = std::min(edge.high(), reach.y);
    if (!(low < high)) continue;
    const double tip = groove.is_outer ? std::min(groove.from.x, groove.to.x) : std::max(groove.from.x, groove.to.x);
    const double edge_most = std::max(edge.a.x, edge.b.x), edge_least = std::min(edge.a.x, edge.b.x);
    if (groove.is_outer ? tip > edge_most - least_groove : tip < edge_least + least_groove) continue;
    part.grooves.push_back(&groove);
    part.low = std::min(part.low, low), part.high = std::max(part.high, high);
  }
  if (part.grooves.empty()) return std::nullopt;
  std::stable_sort(part.grooves.begin(), part.grooves.end(), deeper);
  return part;
}

void add_thread(const ShownEdge& edge, const ThreadedPart& part, const ThreadMesh& mesh,
                const std::function<std::uint32_t(int chord, double radius, double z, std::int32_t maker)>& add_point,
                const std::function<void(std::uint32_t, std::uint32_t, std::uint32_t)>& add_triangle) {
  const ThreadGroove& deepest = *part.grooves.front();
  const double step = deepest.lead / mesh.steps, hand = deepest.left_handed ? -1 : 1;
  const int from = int(std::floor((part.low - deepest.start - deepest.lead) / step));
  const int to = int(std::ceil((part.high - deepest.start + deepest.lead) / step));
  const auto columns = std::uint32_t(to - from + 1);
  const auto z_of = [&](int k, int j) {
    return std::clamp(deepest.start + hand * deepest.lead * k / mesh.chords + j * step, part.low, part.high);
  };
  std::uint32_t first = 0;
  for (int k = mesh.first; k <= mesh.chords; ++k)
    for (int j = from; j <= to; ++j) {
      const double z = z_of(k, j), angle = 2 * std::numbers::pi * k / mesh.chords;
      const auto [radius, maker] = part.at(edge, angle, z);
      const std::uint32_t point = add_point(k, radius, z, maker);
      if (k == mesh.first && j == from) first = point;
    }
  const bool outer = edge.is_outer();
  for (int k = mesh.first; k < mesh.chords; ++k)
    for (int j = from; j < to; ++j) {
      const std::uint32_t here = first + std::uint32_t(k - mesh.first) * columns + std::uint32_t(j - from), next = here + columns;
      if (z_of(k, j) != z_of(k, j + 1)) outer ? add_triangle(here, next, here + 1) : add_triangle(here, here + 1, next);
      if (z_of(k + 1, j) != z_of(k + 1, j + 1)) outer ? add_triangle(next, next + 1, here + 1) : add_triangle(next, here + 1, next + 1);
    }
}

}  // namespace kadr
