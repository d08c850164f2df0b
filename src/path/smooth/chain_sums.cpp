// ChainSums computes with running sums how far the path moves if all corners of a chain (gentle corners close together) are rounded
// together. Used by path/smooth/smooth_path; tested by tests/path/chain_sums_test.cpp.

#include "path/smooth/chain_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "path/smooth/soft_corner.h"

namespace kadr {
namespace {

constexpr double block_length = 16;  // path length, mm, for which the sums are computed at once

struct Pulse {
  // The nodes of the piecewise linear curvature k of a rounding: `node` has the positions r_n, and `kink` has the changes of slope κ_n.
  std::array<double, 5> node, kink;
};

/// Returns the nodes of the curvature k that the rounding of a gentle corner has. This curvature is the acceleration of an axis that starts
/// as SoftCorner defines it, reversed and mirrored, and scaled to the integral 1.
const Pulse& gentle_pulse_nodes() {
  constexpr double equal = SoftCorner::equal_swings;
  static const Pulse pulse = [] {
    const double f = equal / (2 * (equal * equal / 2 - 2 * equal + 1));
    return Pulse{{-1, -(1 - 1 / equal), 0, 1 - 1 / equal, 1}, {-equal * f, 2 * equal * f, -2 * equal * f, 2 * equal * f, -equal * f}};
  }();
  return pulse;
}

}  // namespace

/// Computes the sums for the path from the length s on. The sums include all corners that affect this part of the path.
void ChainSums::reach(const Corners& corners, double s) {
  if (s >= from_ && s <= to_) return;
  constexpr double widest = SoftCorner::widest;
  const double first = s - 2 * widest, last = s + block_length + widest;
  origin_ = s, from_ = s - widest, to_ = s + block_length;
  at_.clear();
  sums_.assign(groups_, Sums());
  for (auto i = static_cast<std::size_t>(std::lower_bound(corners.at.begin(), corners.at.end(), first) - corners.at.begin());
       i < corners.at.size() && corners.at[i] <= last; ++i) {
    if (corners.is_chained[i] == 0) continue;
    const double at = corners.at[i] - origin_;
    at_.push_back(at);
    const std::size_t before = sums_.size() - groups_;
    for (std::size_t g = 0; g < groups_; ++g) {
      Four bend = {};
      for (std::size_t a = g * group; a < std::min(axes_, (g + 1) * group); ++a) bend[a - g * group] = corners.bend[i * axes_ + a];
      Sums sums = sums_[before + g];
      sums.m0 += bend, bend *= at;
      sums.m1 += bend, bend *= at;
      sums.m2 += bend, bend *= at;
      sums.m3 += bend;
      sums_.push_back(sums);
    }
  }
  at_.push_back(std::numeric_limits<double>::infinity());
  for (std::size_t& seen : seen_) seen = std::min(seen, at_.size() - 1);
}

/// Returns the sums over the corners up to the path length y. A corner exactly at y is included.
const ChainSums::Sums* ChainSums::before(std::size_t node, double y) {
  std::size_t& seen = seen_[node];
  while (at_[seen] <= y) ++seen;
  while (seen > 0 && at_[seen - 1] > y) --seen;
  return &sums_[seen * groups_];
}

/// `Groups` is the number of groups of axes as a compile-time constant, so that the sums stay in registers.
template <std::size_t Groups>
void ChainSums::add_shifts(double at, double width, double* x) {
  const Pulse& pulse = gentle_pulse_nodes();
  const double by = 1 / (6 * width * width);
  std::array<Four, Groups> sum{};
  for (std::size_t n = 0; n < nodes; ++n) {
    const double y = at - pulse.node[n] * width, by_m3 = pulse.kink[n] * by, by_m2 = 3 * by_m3 * y, by_m1 = by_m2 * y,
                 by_m0 = by_m3 * y * y * y;
    const Sums* const sums = before(n, y);
    for (std::size_t g = 0; g < Groups; ++g) {
      const Sums& m = sums[g];
      sum[g] += (by_m0 * m.m0 - by_m1 * m.m1) + (by_m2 * m.m2 - by_m3 * m.m3);
      if (n == nodes / 2) sum[g] -= m.m0 * y - m.m1;
    }
  }
  for (std::size_t a = 0; a < axes_; ++a) x[a] += sum[a / group][a % group];
}

void ChainSums::move(const Corners& corners, double s, double width, double* x) {
  reach(corners, s);
  if (at_.size() == 1) return;
  switch (groups_) {
    case 1: return add_shifts<1>(s - origin_, width, x);
    case 2: return add_shifts<2>(s - origin_, width, x);
    case 3: return add_shifts<3>(s - origin_, width, x);
    default: return add_shifts<max_groups>(s - origin_, width, x);
  }
}

void ChainSums::move(const Corners& corners, double s, const WidthAt& width, double* x, double* x1, double* x2) {
  reach(corners, s);
  if (at_.size() == 1) return;
  const Pulse& pulse = gentle_pulse_nodes();
  const double at = s - origin_, w = width.w, by = 1 / (w * w);
  std::array<Four, max_groups> shift{}, slope{}, bend{}, by_w{}, slope_by_w{};
  for (std::size_t n = 0; n < nodes; ++n) {
    const double r = pulse.node[n], y = at - r * w, part = pulse.kink[n] * by;
    const Sums* const sums = before(n, y);
    for (std::size_t g = 0; g < groups_; ++g) {
      const Sums& m = sums[g];
      const Four cubes = ((m.m0 * y - 3 * m.m1) * y + 3 * m.m2) * y - m.m3, squares = (m.m0 * y - 2 * m.m1) * y + m.m2,
                 lines = m.m0 * y - m.m1;
      shift[g] += (part / 6) * cubes;
      slope[g] += (part / 2) * squares;
      bend[g] += part * lines;
      by_w[g] -= part * (cubes / (3 * w) + (r / 2) * squares);
      slope_by_w[g] -= part * (squares / w + r * lines);
      if (n == nodes / 2) shift[g] -= lines, slope[g] -= m.m0;
    }
  }
  for (std::size_t a = 0; a < axes_; ++a) {
    const std::size_t g = a / group, i = a % group;
    x[a] += shift[g][i];
    x1[a] += slope[g][i] + width.w1 * by_w[g][i];
    x2[a] += bend[g][i] + 2 * width.w1 * slope_by_w[g][i] + width.w2 * by_w[g][i];
  }
}

}  // namespace kadr
