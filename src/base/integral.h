#pragma once
// integral(): a definite integral to a given relative error, also for functions with corners and with narrow peaks at the ends. It uses the
// adaptive Simpson rule: an interval is halved if the sum over its halves differs too much from the result for the whole interval.

#include <cmath>
#include <cstddef>

namespace kadr {
namespace detail {

/// An interval of the integration, with the function's values at its ends and its middle.
struct Interval {
  double from, to;
  double at_from, at_middle, at_to;
  double simpson() const { return (to - from) / 6 * (at_from + 4 * at_middle + at_to); }
};

template <class F>
double refined(const F& f, const Interval& s, double error, int depth) {
  const double middle = (s.from + s.to) / 2;
  const Interval left{s.from, middle, s.at_from, f((s.from + middle) / 2), s.at_middle};
  const Interval right{middle, s.to, s.at_middle, f((middle + s.to) / 2), s.at_to};
  const double halves = left.simpson() + right.simpson();
  const double gap = halves - s.simpson();
  // The comparison is negated, so that it is true if f is NaN, and the halving of intervals ends for NaN too.
  if (depth == 0 || !(std::abs(gap) > 15 * error)) return halves + gap / 15;
  return refined(f, left, error / 2, depth - 1) + refined(f, right, error / 2, depth - 1);
}

}  // namespace detail

/// Returns the integral of f from `from` to `to`.
///   relative  greatest error, relative to the integral of |f|; guaranteed only if f has no inner peak narrower than 1/16 of the interval
///   law       the result is NaN if f is NaN somewhere
template <class F>
double integral(const F& f, double from, double to, double relative) {
  constexpr int intervals = 16;
  constexpr int max_halvings = 48;
  // Greatest number of passes over the interval. The permitted error of a pass is relative to an estimate of the integral's size. A peak at
  // an end of the interval makes the first estimate far too large, so a pass is repeated with the size that it found.
  constexpr int max_rounds = 4;
  double size = 0;
  for (int i = 0; i <= intervals; ++i) size += std::abs(f(from + (to - from) * i / intervals) * (to - from) / intervals);
  double sum = 0;
  for (int round = 0; round < max_rounds; ++round) {
    sum = 0;
    for (int i = 0; i < intervals; ++i) {
      const double a = from + (to - from) * i / intervals, b = from + (to - from) * (i + 1) / intervals;
      sum += detail::refined(f, {a, b, f(a), f((a + b) / 2), f(b)}, relative * size / intervals, max_halvings);
    }
    if (!(std::abs(sum) < size / 2)) break;
    size = std::abs(sum);
  }
  return sum;
}

}  // namespace kadr
