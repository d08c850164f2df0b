// LeastTime, the interior-point method: the Newton steps and the line search.

#include "motion/least_time/least_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kadr {
void LeastTime::spread(const std::vector<double>& y) {
  for (std::size_t k = first_given_ ? 1 : 0; k < n_; ++k) m_[k] = scale_[k] * y[variable_[k]];
}

double LeastTime::time() const {
  double sum = 0;
  for (std::size_t k = 0; k < n_; ++k) sum += path_->h[k] / std::sqrt(m_[k]);
  return sum;
}

/// Solves H · step_ = −gradient_ by the decomposition H = L D Lᵀ, where H is the Hessian. If limits of very different magnitudes act
/// together, rounding errors may make an element d of D zero or negative. The diagonal element of H then replaces d (Gill, Murray, Wright:
/// Practical Optimization 4.4.2). The step becomes shorter, but it still decreases the objective.
///   returns  false if H is not positive definite
bool LeastTime::newton_step() {
  constexpr double rounding = 1e-13;
  factors_ = hessian_;
  auto& [h0, h1, h2] = factors_;
  for (std::size_t i = 0; i < variables_; ++i) {
    double d = h0[i], z = -gradient_[i];
    if (i >= 2) {
      const double l = h2[i - 2] / h0[i - 2];
      d -= l * h2[i - 2];
      // The element h1[i − 2] already holds the factor l₁ of L and not the element of the Hessian, so it is multiplied by d.
      h1[i - 1] -= l * h1[i - 2] * h0[i - 2];
      z -= l * step_[i - 2];
      h2[i - 2] = l;
    }
    if (i >= 1) {
      const double l = h1[i - 1] / h0[i - 1];
      d -= l * h1[i - 1];
      z -= l * step_[i - 1];
      h1[i - 1] = l;
    }
    if (!(d > rounding * hessian_.h0[i])) d = hessian_.h0[i];
    if (!(d > 0) || !std::isfinite(d)) return false;
    h0[i] = d;
    step_[i] = z;
  }
  for (std::size_t i = variables_; i-- > 0;) {
    double x = step_[i] / h0[i];
    if (i + 1 < variables_) x -= h1[i] * step_[i + 1];
    if (i + 2 < variables_) x -= h2[i] * step_[i + 2];
    step_[i] = x;
  }
  return true;
}

/// Changes the variables along step_, halving the step until the barrier function decreases enough.
///   returns  the decrease that the slope predicts (to first order); 0 if no descent was found
double LeastTime::line_search(double mu) {
  constexpr double enough = 0.01;  // Least accepted decrease, as a fraction of the decrease that the slope predicts (Armijo's rule).
  constexpr int max_halvings = 40;
  double falls = 0, part = 1;
  for (std::size_t v = 0; v < variables_; ++v) {
    falls -= gradient_[v] * step_[v];
    if (step_[v] < 0) part = std::min(part, -0.95 * y_[v] / step_[v]);
  }
  const double value = height_.at(mu);
  for (int halved = 0; halved < max_halvings; ++halved, part *= 0.5) {
    for (std::size_t v = 0; v < variables_; ++v) trial_[v] = y_[v] + part * step_[v];
    const Height height = this->height(trial_);
    if (!(height.at(mu) <= value - enough * part * falls)) continue;
    height_ = height;
    std::swap(y_, trial_);
    return falls;
  }
  spread(y_);
  return 0;
}

/// Sets the first guess of the solution. The first cells get the speeds of the earlier solution. After these cells the squared path speed b
/// decreases from cell to cell. The decrease per cell grows to a tenth of b; `gently` is the number of cells after which a tenth is
/// reached.
///   returns  false if the guess exceeds a limit
bool LeastTime::can_continue_crawling(double gently) {
  constexpr double slowing = 0.1;  // greatest decrease of the squared path speed b per cell, as a fraction of b
  const double slow = ends_.guess.back(), size = path_->h[ends_.guess.size() - 1];
  for (const double floor : {slow, slow / 10, ends_.crawl / 1e4}) {
    double m = slow, cells = 0;
    std::fill(y_.begin(), y_.end(), std::numeric_limits<double>::infinity());
    for (std::size_t k = first_given_ ? 1 : 0; k < n_; ++k) {
      double less = slowing;
      if (gently > 1) less *= std::min(1.0, (cells += k < ends_.guess.size() ? 0 : 1) / gently) * std::min(1.0, path_->h[k] / size);
      m = k < ends_.guess.size() ? ends_.guess[k] : std::max(floor, m * (1 - less));
      // Next to a stop or a reversal several cells have a common variable. The slowest of these cells determines the value of the variable.
      double& y = y_[variable_[k]];
      y = std::min(y, m / scale_[k]);
    }
    if (is_within(y_)) return true;
  }
  return false;
}

/// Sets the first guess of the solution. The first cells get the speeds of the earlier solution, and all later cells the speed of the last
/// of these cells. Near the final stop and the reversals the speed is lower: at most the speed that a start from rest with constant jerk
/// reaches at the same distance.
///   returns  false if the guess exceeds a limit
bool LeastTime::can_continue_to_stop() {
  constexpr int max_tries = 16;
  const double slow = ends_.guess.back();
  const std::size_t known = ends_.guess.size();
  // The path distance between the middle of each cell and the nearest stop or reversal, mm.
  std::vector<double> away(n_, std::numeric_limits<double>::infinity());
  double since_stop = std::numeric_limits<double>::infinity();
  const auto pass = [&](std::size_t k, bool stops) {
    if (stops) since_stop = 0;
    away[k] = std::min(away[k], since_stop + path_->h[k] / 2);
    since_stop += path_->h[k];
  };
  for (std::size_t k = 0; k < n_; ++k) pass(k, k > 0 && turns_after(k - 1));
  since_stop = std::numeric_limits<double>::infinity();
  for (std::size_t k = n_; k-- > 0;) pass(k, k + 1 == n_ || turns_after(k));
  double part = soonest_rise(*path_);
  for (int tries = 0; tries < max_tries; ++tries, part *= 0.7) {
    std::fill(y_.begin(), y_.end(), std::numeric_limits<double>::infinity());
    for (std::size_t k = first_given_ ? 1 : 0; k < n_; ++k) {
      const double m = k < known ? ends_.guess[k] : 1 / std::hypot(1 / slow, std::pow(part * away[k], -4.0 / 3));
      double& y = y_[variable_[k]];
      y = std::min(y, m / scale_[k]);
    }
    if (is_within(y_)) return true;
  }
  return false;
}

/// Finds initial values of the variables that obey all limits. These are the values of an earlier solution that continues at a low speed,
/// or values for a speed so low in every cell that all limits are far away.
bool LeastTime::first_guess() {
  // number of new cells over which the deceleration grows to its full value; 1: at the first new cell
  for (const double gently : {1., 30., 100., 300.})
    if (!ends_.guess.empty() && can_continue_crawling(gently)) return true;
  if (!ends_.guess.empty() && ends_.to_stop && can_continue_to_stop()) return true;
  if (!ends_.from_stop) return false;
  find_envelope();
  constexpr int max_tries = 60;
  double part = 0.5;
  for (int tries = 0; tries < max_tries; ++tries, part /= 2) {
    for (std::size_t k = n_; k-- > 0;) y_[variable_[k]] = part * std::min(m_[k] / scale_[k], cap_[variable_[k]]);
    std::copy(y_.begin(), y_.end(), trial_.begin());
    if (is_within(trial_)) return true;
    find_envelope();
  }
  return false;
}

bool LeastTime::solve(const TimedPath& path, const PathEnds& ends, StopToken stop) {
  // factor by which the barrier parameter μ is reduced when the solution is near the optimum for the current μ
  constexpr double smaller = 0.2;
  // Final accuracy: μ is reduced until the logarithmic barrier makes the path time at most this fraction longer than the shortest time.
  constexpr double accurate = 5e-4;
  // The barrier parameter μ is reduced when the decrease that is predicted for the next step is below this fraction of the time that the
  // barrier costs.
  constexpr double near_enough = 0.3;
  constexpr int max_rounds = 4;   // greatest number of attempts to shorten a Newton step in the cells in which the step violates limits
  constexpr int max_steps = 150;  // greatest number of Newton steps; 25 to 45 steps suffice
  path_ = &path;
  ends_ = ends;
  prepare();
  steps_ = 0;
  if (!first_guess()) return false;
  const double conditions = static_cast<double>(n_) * (1 + 2 * static_cast<double>(places * path.axes));
  height_ = height(y_);
  double mu = height_.time / conditions;
  while (steps_++ < max_steps && !stop.requested()) {
    derivatives(mu);
    bool positive = newton_step();
    for (int round = 0; positive && round < max_rounds && stiffen(mu, round == 0); ++round) positive = newton_step();
    if (!positive) break;
    const double falls = line_search(mu);
    if (falls >= near_enough * mu * conditions) continue;
    if (mu * conditions < accurate * height_.time || falls == 0) break;
    mu = std::min(mu, height_.time / conditions) * smaller;
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
