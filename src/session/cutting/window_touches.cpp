// Merges the contacts that were found in the whole stock and in its window. This file is used by session/cutting/cutting.

#include "session/cutting/window_touches.h"

#include <tuple>

namespace kadr {
namespace {

auto sweep_and_part(const Touch& t) { return std::tuple(t.sweep, t.part); }

}  // namespace

bool is_within(const Box3& inner, const Box3& outer) {
  constexpr double hair = 1e-3;  // tolerance of the comparison, mm; needed because the boxes have single precision
  for (int d = 0; d < 3; ++d)
    if (along(inner.least, d) < along(outer.least, d) - hair || along(inner.most, d) > along(outer.most, d) + hair) return false;
  return true;
}

std::vector<Touch> finer_touches(const Box3& window, const std::vector<Touch>& whole, const std::vector<Touch>& fine) {
  std::vector<Touch> all;
  auto next = fine.begin();
  for (const Touch& of_whole : whole) {
    for (; next != fine.end() && sweep_and_part(*next) < sweep_and_part(of_whole); ++next) all.push_back(*next);
    if (!of_whole.rings && is_within(of_whole.around, window)) continue;
    Touch& touch = all.emplace_back(of_whole);
    if (next != fine.end() && sweep_and_part(*next) == sweep_and_part(of_whole)) touch.around.include((next++)->around);
  }
  all.insert(all.end(), next, fine.end());
  return all;
}

}  // namespace kadr
