#include "path/smooth/slow_width.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

namespace kadr::slow_width_test {
namespace {

constexpr double path_length = 30;

/// Returns the width along a path of 30 mm after random limits.
SlowWidth random_width() {
  SlowWidth width;
  width.begin();
  width.open(path_length);
  for (const int limits : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 3000)))
    width.limit(limits * 0.01, 0.05 + 0.001 * *rc::gen::inRange(0, 2000));
  width.close();
  return width;
}

RC_GTEST_PROP(SlowWidthProperty, GreatestIsABound, ()) {
  const SlowWidth width = random_width();
  const double from = 0.001 * *rc::gen::inRange(0, 29000), to = std::min(path_length, from + 0.001 * *rc::gen::inRange(0, 3000));
  const double greatest = width.greatest(from, to);
  double seen = 0;
  for (int k = 0; k <= 300; ++k) seen = std::max(seen, width.at(from + (to - from) * k / 300).w);
  RC_ASSERT(seen <= greatest * (1 + 1e-14));
  RC_ASSERT(greatest <= seen + 0.06);  // 0.15 mm per mm along two intervals of 0.1 mm to each side
}

RC_GTEST_PROP(SlowWidthProperty, ChangesSlowly, ()) {
  const SlowWidth width = random_width();
  for (double s = 0; s < path_length; s += 0.03) {
    const WidthAt at = width.at(s);
    RC_ASSERT(at.w > 0 && at.w <= 2 + 1e-12);
    RC_ASSERT(std::abs(at.w1) <= 0.15 + 1e-9);
  }
}

}  // namespace
}  // namespace kadr::slow_width_test
