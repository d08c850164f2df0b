// Sorts and adds the touches of bricks. Used by stock/stock.

#include "stock/portion/sweep_touches.h"

#include <algorithm>
#include <tuple>

namespace kadr {

std::vector<Touch> one_for_each_sweep(std::vector<Touch> touches) {
  const auto key = [](const Touch& t) {
    return std::tuple(t.sweep, t.part, t.around.least.z, t.around.least.y, t.around.least.x, t.volume);
  };
  std::sort(touches.begin(), touches.end(), [&](const Touch& a, const Touch& b) { return key(a) < key(b); });
  std::vector<Touch> together;
  for (const Touch& t : touches) {
    if (together.empty() || together.back().sweep != t.sweep || together.back().part != t.part) {
      together.push_back(t);
      continue;
    }
    Touch& all = together.back();
    all.around.include(t.around);
    all.volume += t.volume;
  }
  return together;
}

}  // namespace kadr
