#pragma once
// range_of(): the least and the greatest value of a function over 0..1. It samples the function at equal distances, then searches around
// each extreme sample by the golden section.

#include <algorithm>
#include <utility>
#include <vector>

namespace kadr {

struct Range {
  double least = 0;
  double most = 0;
};

/// Returns the x in [low, high] at which `f` is least. `f` must have a single minimum there.
template <class F>
double place_of_least(const F& f, double low, double high) {
  constexpr double golden = 0.61803398874989485;
  constexpr int max_steps = 80;
  constexpr double near_enough = 1e-11;  // tolerance of x, whose range is about 1: over a smaller distance f(x) does not change
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double at_a = f(a), at_b = f(b);
  for (int step = 0; step < max_steps && high - low > near_enough; ++step) {
    if (at_a < at_b) {
      high = std::exchange(b, a);
      at_b = at_a;
      a = high - golden * (high - low);
      at_a = f(a);
    } else {
      low = std::exchange(a, b);
      at_a = at_b;
      b = low + golden * (high - low);
      at_b = f(b);
    }
  }
  return at_a < at_b ? a : b;
}

/// Returns the least and greatest value of f over 0..1, both ends included.
///   samples  number of sampling intervals; at most one extreme may lie between two neighbouring samples
template <class F>
Range range_of(const F& f, int samples) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(samples) + 1);
  for (int i = 0; i <= samples; ++i) values.push_back(f(double(i) / samples));
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  Range range{*least, *most};
  if (range.least == range.most) return range;
  for (int i = 0; i <= samples; ++i) {
    const auto place = static_cast<std::size_t>(i);
    const double here = values[place], before = values[place - (i > 0 ? 1 : 0)], after = values[place + (i < samples ? 1 : 0)];
    const double low = std::max(0.0, (i - 1.0) / samples), high = std::min(1.0, (i + 1.0) / samples);
    if (here <= before && here <= after) range.least = std::min(range.least, f(place_of_least(f, low, high)));
    if (here >= before && here >= after)
      range.most = std::max(range.most, f(place_of_least([&](double part) { return -f(part); }, low, high)));
  }
  return range;
}

}  // namespace kadr
