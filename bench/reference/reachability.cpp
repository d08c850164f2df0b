#include "reachability.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kadr::reference {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The inequality p u + q b ≤ r for one limit. u = s̈ and b = ṡ² are path acceleration and squared path speed at the start of an
/// interval.
struct Row {
  double p, q, r;
};

/// The limits of one interval of length h. At its end ṡ² is b + 2 h u.
class Rows {
 public:
  Rows(const Grid& grid, const MotionLimits& limits, std::size_t interval, double most_at_end) {
    const double h = grid.h[interval];
    for (std::size_t a = 0; a < limits.acceleration.size(); ++a)
      for (const double sign : {-1.0, 1.0}) {
        const Place &from = grid.start[interval], &to = grid.end[interval];
        add(sign * from.x1[a], sign * from.x2[a], limits.acceleration[a]);
        add(sign * (to.x1[a] + 2 * h * to.x2[a]), sign * to.x2[a], limits.acceleration[a]);
      }
    add(2 * h, 1, most_at_end);
    add(-2 * h, -1, 0);
  }

  /// Returns the greatest b, up to `most`, for which a u exists, that is, no lower bound of u is above an upper bound.
  double greatest_b(double most) const {
    for (const Row& row : rows_)
      if (row.p == 0 && row.q > 0) most = std::min(most, row.r / row.q);
    for (const Row& upper : rows_)
      for (const Row& lower : rows_) {
        if (!(upper.p > 0) || !(lower.p < 0)) continue;
        const double q = upper.q / upper.p - lower.q / lower.p, r = upper.r / upper.p - lower.r / lower.p;
        if (q > 0) most = std::min(most, r / q);
      }
    return std::max(0.0, most);
  }

  double greatest_u(double b) const {
    double most = infinite;
    for (const Row& row : rows_)
      if (row.p > 0) most = std::min(most, (row.r - row.q * b) / row.p);
    return most;
  }

 private:
  void add(double p, double q, double r) {
    if (p != 0 || q != 0) rows_.push_back({p, q, r});
  }
  std::vector<Row> rows_;
};

}  // namespace

PathMotion without_jerk(const Grid& grid, const MotionLimits& limits) {
  const std::size_t n = grid.intervals();
  std::vector<double> most(n + 1, 0);  // greatest ṡ² at each knot from which the motion can still stop at the end
  for (std::size_t i = n; i-- > 0;) most[i] = Rows(grid, limits, i, most[i + 1]).greatest_b(grid.most(i));
  PathMotion motion{{0}, {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const double v = motion.v[i], u = Rows(grid, limits, i, most[i + 1]).greatest_u(v * v);
    motion.a.push_back(u);
    motion.v.push_back(std::sqrt(std::clamp(v * v + 2 * grid.h[i] * u, 0.0, most[i + 1])));
    motion.seconds.push_back(2 * grid.h[i] / (v + motion.v[i + 1]));
  }
  motion.a.push_back(0);
  return motion;
}

}  // namespace kadr::reference
