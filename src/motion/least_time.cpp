// The interior-point method: barrier, Newton steps, line search.

#include "motion/least_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/least_time_places.h"

namespace kadr {
namespace {

using least_time::weights;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Value at the places of what is linear in the ordinates.
template <class Rows, class Ordinates>
std::array<double, TimedPath::places> at_places(const Rows& rows, const Ordinates& o) {
  std::array<double, TimedPath::places> at;
  for (std::size_t p = 0; p < TimedPath::places; ++p) at[p] = rows[0][p] * o[0] + rows[1][p] * o[1] + rows[2][p] * o[2];
  return at;
}

/// Gradient and Hessian of −Σ log(1 − x²) by the ordinates, at each place by itself: so the places are calculated side by side.
struct Sums {
  using Places = std::array<double, TimedPath::places>;
  std::array<Places, 9> at{};  // gradient 0 1 2, Hessian 00 01 02 11 12 22

  void take(const Places& x, const std::array<Places, 3>& by) {
    for (std::size_t p = 0; p < TimedPath::places; ++p) {
      const double inverse = 1 / (1 - x[p] * x[p]), slope = 2 * x[p] * inverse, bend = 2 * inverse + slope * slope;
      const double b0 = by[0][p], b1 = by[1][p], b2 = by[2][p];
      at[0][p] += slope * b0, at[1][p] += slope * b1, at[2][p] += slope * b2;
      at[3][p] += bend * b0 * b0, at[4][p] += bend * b0 * b1, at[5][p] += bend * b0 * b2;
      at[6][p] += bend * b1 * b1, at[7][p] += bend * b1 * b2, at[8][p] += bend * b2 * b2;
    }
  }
  std::array<double, 9> over_places() const {
    std::array<double, 9> sums{};
    for (std::size_t i = 0; i < sums.size(); ++i)
      for (const double x : at[i]) sums[i] += x;
    return sums;
  }
};

/// Sum of logarithms, one for many factors.
class Logs {
 public:
  void take(double factor) {
    product_ *= factor;
    if (product_ < 1e-200) sum_ += std::log(product_), product_ = 1;
  }
  double sum() const { return sum_ + std::log(product_); }

 private:
  double sum_ = 0, product_ = 1;
};

}  // namespace

void LeastTime::spread(const std::vector<double>& y) {
  for (std::size_t k = first_given_ ? 1 : 0; k < n_; ++k) m_[k] = scale_[k] * y[variable_[k]];
}

LeastTime::Ordinates LeastTime::ordinates(std::size_t cell) const {
  const auto knot = [&](std::size_t left) {
    if (turns_behind(left)) return 0.0;
    const double before = path_->h[left], behind = path_->h[left + 1];
    return (behind * m_[left] + before * m_[left + 1]) / (before + behind);
  };
  const double start = cell > 0 ? knot(cell - 1) : first_given_ ? ends_.from.b : 0;
  return {start, m_[cell], cell + 1 < n_ ? knot(cell) : turns_behind(cell) ? 0 : m_[cell]};
}

double LeastTime::time() const {
  double sum = 0;
  for (std::size_t k = 0; k < n_; ++k) sum += path_->h[k] / std::sqrt(m_[k]);
  return sum;
}

/// T − μ Σ log(slack); infinite where a limit is not kept. A limit |x| ≤ 1 has the slack 1 − x². Leaves m_ as it is for y.
double LeastTime::barrier(const std::vector<double>& y, double mu) {
  Logs logs;
  for (std::size_t v = 0; v < variables_; ++v) {
    if (!(y[v] > 0) || !(y[v] < cap_[v])) return infinite;
    logs.take(1 - y[v] / cap_[v]);
  }
  spread(y);
  for (std::size_t k = 0; k < n_; ++k) {
    if (is_stop_cell(k)) continue;
    const Ordinates o = ordinates(k);
    const Places b = at_places(weights, o);
    for (std::size_t row = 0; row < moving_.size(); ++row) {
      const AxisLimits& limits = limits_[k * moving_.size() + row];
      const Places acceleration = at_places(limits.acceleration, o), jerk = at_places(limits.jerk, o);
      double least = 1, product = 1;
      for (std::size_t p = 0; p < places; ++p) {
        const double slack = 1 - acceleration[p] * acceleration[p], jerk_slack = 1 - b[p] * jerk[p] * jerk[p];
        least = std::min(least, std::min(slack, jerk_slack));
        product *= slack * jerk_slack;
      }
      if (!(least > 0)) return infinite;
      logs.take(product);
    }
  }
  return time() - mu * logs.sum();
}

/// The limits within a cell: their gradient and Hessian by its ordinates, then by the variables.
void LeastTime::add_cell(std::size_t cell, double mu) {
  const Ordinates o = ordinates(cell);
  const Places b = at_places(weights, o);
  Places root, half;
  for (std::size_t p = 0; p < places; ++p) root[p] = std::sqrt(b[p]), half[p] = b[p] > 0 ? 0.5 / root[p] : 0;
  Sums sums;
  for (std::size_t row = 0; row < moving_.size(); ++row) {
    const AxisLimits& limits = limits_[cell * moving_.size() + row];
    sums.take(at_places(limits.acceleration, o), limits.acceleration);
    const Places jerk = at_places(limits.jerk, o);
    std::array<Places, 3> by;
    Places part;
    for (std::size_t p = 0; p < places; ++p) {
      part[p] = root[p] * jerk[p];
      for (std::size_t i = 0; i < 3; ++i) by[i][p] = root[p] * limits.jerk[i][p] + half[p] * jerk[p] * weights[i][p];
    }
    sums.take(part, by);
  }
  const std::array<double, 9> sum = sums.over_places();
  const Three gradient{sum[0], sum[1], sum[2]};
  const std::array<Three, 3> h{{{sum[3], sum[4], sum[5]}, {sum[4], sum[6], sum[7]}, {sum[5], sum[7], sum[8]}}};
  // ordinates by variables
  const std::size_t first = first_variable(cell);
  std::array<Three, 3> by{mixes_[cell][0].by, {}, mixes_[cell][1].by};
  if (!(cell == 0 && first_given_)) by[1][variable_[cell] - first] = scale_[cell];
  std::array<Three, 3> hb{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t v = 0; v < 3; ++v) hb[i][v] = mu * (h[i][0] * by[0][v] + h[i][1] * by[1][v] + h[i][2] * by[2][v]);
  const auto product = [&](std::size_t v, std::size_t w) { return by[0][v] * hb[0][w] + by[1][v] * hb[1][w] + by[2][v] * hb[2][w]; };
  for (std::size_t v = 0; v < 3; ++v) {
    gradient_[first + v] += mu * (gradient[0] * by[0][v] + gradient[1] * by[1][v] + gradient[2] * by[2][v]);
    h0_[first + v] += product(v, v);
  }
  h1_[first] += product(0, 1);
  h1_[first + 1] += product(1, 2);
  h2_[first] += product(0, 2);
}

/// Gradient and Hessian of the barrier at y_; m_ is that of y_.
void LeastTime::derivatives(double mu) {
  constexpr std::size_t beyond = 2;  // a cell's limits may name variables that are none; their derivatives are 0
  for (std::vector<double>* const all : {&gradient_, &h0_, &h1_, &h2_}) all->assign(variables_ + beyond, 0);
  for (std::size_t v = 0; v < variables_; ++v) {
    const double slack = 1 / (cap_[v] - y_[v]);
    gradient_[v] += mu * slack;
    h0_[v] += mu * slack * slack;
  }
  for (std::size_t k = first_given_ ? 1 : 0; k < n_; ++k) {
    const double by_m = path_->h[k] / (m_[k] * std::sqrt(m_[k]));
    gradient_[variable_[k]] -= 0.5 * by_m * scale_[k];
    h0_[variable_[k]] += 0.75 * by_m / m_[k] * scale_[k] * scale_[k];
  }
  for (std::size_t k = 0; k < n_; ++k)
    if (!is_stop_cell(k)) add_cell(k, mu);
}

/// H · step_ = −gradient_, by L D Lᵀ of five diagonals; L stays in h1_ and h2_, D in h0_.
///   returns  false: H is not positive
bool LeastTime::newton_step() {
  for (std::size_t i = 0; i < variables_; ++i) {
    double d = h0_[i], z = -gradient_[i];
    if (i >= 2) {
      const double l = h2_[i - 2] / h0_[i - 2];
      d -= l * h2_[i - 2];
      h1_[i - 1] -= l * h1_[i - 2] * h0_[i - 2];  // h1_[i − 2] is L by now
      z -= l * step_[i - 2];
      h2_[i - 2] = l;
    }
    if (i >= 1) {
      const double l = h1_[i - 1] / h0_[i - 1];
      d -= l * h1_[i - 1];
      z -= l * step_[i - 1];
      h1_[i - 1] = l;
    }
    if (!(d > 0) || !std::isfinite(d)) return false;
    h0_[i] = d;
    step_[i] = z;
  }
  for (std::size_t i = variables_; i-- > 0;) {
    double x = step_[i] / h0_[i];
    if (i + 1 < variables_) x -= h1_[i] * step_[i + 1];
    if (i + 2 < variables_) x -= h2_[i] * step_[i + 2];
    step_[i] = x;
  }
  return true;
}

/// Goes along step_ as far as it lowers the barrier.
///   returns  how much it would have fallen by the slope alone; 0: no way down was found
double LeastTime::line_search(double value, double mu) {
  constexpr double enough = 0.01;  // of the fall that the slope promises (Armijo)
  constexpr int most_halvings = 40;
  double falls = 0, part = 1;
  for (std::size_t v = 0; v < variables_; ++v) {
    falls -= gradient_[v] * step_[v];
    if (step_[v] < 0) part = std::min(part, -0.95 * y_[v] / step_[v]);
  }
  for (int halved = 0; halved < most_halvings; ++halved, part *= 0.5) {
    for (std::size_t v = 0; v < variables_; ++v) trial_[v] = y_[v] + part * step_[v];
    if (!(barrier(trial_, mu) <= value - enough * part * falls)) continue;
    std::swap(y_, trial_);
    return falls;
  }
  spread(y_);
  return 0;
}

/// A speed that obeys all limits: an earlier solution that crawls on behind its end, or one so low that all limits are far away.
bool LeastTime::first_guess() {
  constexpr double slowing = 0.9;  // of b, from cell to cell
  if (!ends_.guess.empty()) {
    const double slow = ends_.guess.back();
    for (const double floor : {slow, slow / 10, ends_.crawl / 1e4}) {
      double m = slow;
      std::vector<double>& y = y_;
      for (std::size_t k = first_given_ ? 1 : 0; k < n_; ++k) {
        m = k < ends_.guess.size() ? ends_.guess[k] : std::max(floor, m * slowing);
        y[variable_[k]] = m / scale_[k];
      }
      if (std::isfinite(barrier(y_, 0))) return true;
    }
  }
  if (!ends_.from_stop) return false;
  find_envelope();
  constexpr int most_tries = 60;
  double part = 0.5;
  for (int tries = 0; tries < most_tries; ++tries, part /= 2) {
    for (std::size_t k = n_; k-- > 0;) y_[variable_[k]] = part * std::min(m_[k] / scale_[k], cap_[variable_[k]]);
    std::copy(y_.begin(), y_.end(), trial_.begin());
    if (std::isfinite(barrier(trial_, 0))) return true;
    find_envelope();
  }
  return false;
}

bool LeastTime::solve(const TimedPath& path, const Ends& ends) {
  constexpr double smaller = 0.2;      // μ, when its point is near
  constexpr double accurate = 5e-4;    // of the time: what μ may cost
  constexpr double near_enough = 0.3;  // of what μ may cost: what the next step promises
  constexpr int most_steps = 150;      // 25 to 45 are needed
  path_ = &path;
  ends_ = ends;
  prepare();
  steps_ = 0;
  if (!first_guess()) return false;
  const double conditions = static_cast<double>(n_) * (1 + 2 * static_cast<double>(TimedPath::places * path.axes));
  double mu = time() / conditions;
  while (steps_++ < most_steps) {
    derivatives(mu);
    if (!newton_step()) break;
    const double falls = line_search(barrier(y_, mu), mu);
    if (falls >= near_enough * mu * conditions) continue;
    const double now = time();
    if (mu * conditions < accurate * now || falls == 0) break;
    mu = std::min(mu, now / conditions) * smaller;
  }
  speeds_.resize(n_);
  for (std::size_t k = 0; k < n_; ++k) {
    const Ordinates o = ordinates(k);
    speeds_[k] = {{o[0], 2 * (o[1] - o[0]) / path.h[k]}, {o[2], 2 * (o[2] - o[1]) / path.h[k]}};
    if (is_stop_cell(k)) (k == 0 ? speeds_[k].start : speeds_[k].end) = {};
  }
  return true;
}

}  // namespace kadr
