// SlowWidth computes the width of the roundings of a chain of corners along the path. Used by path/smooth/smooth_path; tested by
// tests/path/slow_width_test.cpp.

#include "path/smooth/slow_width.h"

#include <algorithm>
#include <cmath>

#include "path/smooth/soft_corner.h"

namespace kadr {
namespace {

constexpr double part_length = 0.1;  // length of an interval of the path, mm; the names `part` and `parts` refer to such intervals
constexpr double slope = 0.15;       // greatest change of the width per path length, mm/mm
constexpr double levelled = 0.5;     // Extent of the window for the minimum and the mean to each side, as a fraction of the width.
constexpr double widest = SoftCorner::widest;
// Number of filter passes. Each pass extends the window by one interval to both sides.
constexpr int rounds = static_cast<int>(levelled * widest / part_length + 0.5);
constexpr std::size_t reach = 2 * rounds + 4;  // extent of both filters together, as a number of intervals

// The knots of the spline are in the middle of the intervals, so 0.5 is added to convert a number of intervals to a number of knots.
double knots_to(double s) { return std::max(0.0, s / part_length) + 0.5; }

std::size_t knot_of(double s) { return static_cast<std::size_t>(knots_to(s)); }

}  // namespace

double SlowWidth::felt() { return widest / slope + static_cast<double>(reach) * part_length; }

std::size_t SlowWidth::part_of(double at) const { return static_cast<std::size_t>(std::max(0.0, at / part_length)); }

void SlowWidth::begin() {
  first_ = settled_ = 0;
  raw_.assign(8, widest);
  width_.assign(8, widest);
}

void SlowWidth::open(double end) {
  const std::size_t parts = part_of(end) + 6 - first_;
  raw_.resize(settled_ - first_);
  raw_.resize(parts, widest);
  width_.resize(parts, widest);
}

void SlowWidth::limit(double at, double width) {
  const std::size_t part = part_of(at) + 2;
  if (part < settled_ || part - first_ >= raw_.size()) return;
  double& raw = raw_[part - first_];
  raw = std::min(raw, width);
}

/// Replaces the value of each interval by the minimum or the mean of the intervals in the window around it. The extent of the window is a
/// fraction of the width. Each pass of the filter combines direct neighbours, so the number of passes that change an interval is
/// proportional to its width.
void SlowWidth::level(std::vector<double>& parts, bool mean) {
  const std::size_t n = parts.size();
  next_ = parts;
  for (int round = 1; round <= rounds; ++round) {
    const double least = round * part_length / levelled;
    for (std::size_t k = 1; k + 1 < n; ++k) {
      const double a = parts[k - 1], b = parts[k], c = parts[k + 1];
      const double level = mean ? (a + b + c) * (1.0 / 3) : std::min(std::min(a, b), c);
      next_[k] = b >= least ? level : b;
    }
    next_[0] = next_[1], next_[n - 1] = next_[n - 2];
    parts.swap(next_);
  }
}

void SlowWidth::close() {
  const std::size_t n = raw_.size(), open = settled_ - first_;
  for (std::size_t k = std::max<std::size_t>(open, 1); k < n; ++k) raw_[k] = std::min(raw_[k], raw_[k - 1] + slope * part_length);
  for (std::size_t k = n - 1; k-- > open;) raw_[k] = std::min(raw_[k], raw_[k + 1] + slope * part_length);
  const std::size_t from = open > 2 * reach ? open - 2 * reach : 0;
  now_.assign(raw_.begin() + static_cast<std::ptrdiff_t>(from), raw_.end());
  level(now_, false);
  level(now_, true);
  std::copy(now_.begin() + static_cast<std::ptrdiff_t>(open - from), now_.end(), width_.begin() + static_cast<std::ptrdiff_t>(open));
}

void SlowWidth::settle(double before) { settled_ = std::max(settled_, std::min(part_of(before) + 5, first_ + raw_.size())); }

void SlowWidth::forget(double before) {
  const std::size_t part = part_of(before), kept = 3 * reach;
  if (part <= first_ + kept) return;
  const std::size_t drop = std::min(part - kept, settled_) - first_;
  for (std::vector<double>* const all : {&raw_, &width_}) all->erase(all->begin(), all->begin() + static_cast<std::ptrdiff_t>(drop));
  first_ += drop;
}

WidthAt SlowWidth::at(double s) const {
  const double place = knots_to(s);
  const auto knot = static_cast<std::size_t>(place);
  const double f = place - static_cast<double>(knot), g = 1 - f;
  const double* const w = width_.data() + std::min(knot - first_, width_.size() - 4);
  return {(g * g * g * w[0] + (4 - f * f * (6 - 3 * f)) * w[1] + (4 - g * g * (6 - 3 * g)) * w[2] + f * f * f * w[3]) / 6,
          (-g * g * w[0] + f * (3 * f - 4) * w[1] + g * (4 - 3 * g) * w[2] + f * f * w[3]) / (2 * part_length),
          (g * w[0] + (3 * f - 2) * w[1] + (1 - 3 * f) * w[2] + f * w[3]) / (part_length * part_length)};
}

double SlowWidth::greatest(double from, double to) const {
  const std::size_t last = width_.size() - 4, a = std::min(knot_of(from) - first_, last), b = std::min(knot_of(to) - first_, last);
  const auto begin = width_.begin() + static_cast<std::ptrdiff_t>(a), end = width_.begin() + static_cast<std::ptrdiff_t>(b) + 4;
  return *std::max_element(begin, end);  // a B-spline does not leave the hull of its knots
}

}  // namespace kadr
