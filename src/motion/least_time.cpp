#include "motion/least_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kadr {
namespace {

constexpr double margin = 0.99;  // of acceleration and jerk: between the places they are looked at they are a little higher
constexpr double infinite = std::numeric_limits<double>::infinity();

double square(double x) { return x * x; }

/// ṡ² and its derivative at a part of a cell, by its Bézier ordinates.
PathSpeed within(const PathSpeed& left, double m, const PathSpeed& right, double part) {
  const double rest = 1 - part;
  return {rest * rest * left.b + 2 * part * rest * m + part * part * right.b, rest * left.d + part * right.d};
}

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

void TimedPath::clear() {
  for (std::vector<double>* const all : {&h, &most, &x1, &x2, &x3}) all->clear();
  turns.clear();
}

/// A cell beside a stop has b = b₁ (σ/h)^(4/3), so that at its inner knot b′ = 4/3 b₁/h: its middle is a third of b₁.
void LeastTime::number_variables() {
  const std::vector<double>& h = path_->h;
  variable_.assign(n_, 0);
  scale_.assign(n_, 1);
  first_given_ = !ends_.from_stop;
  std::size_t count = 0;
  for (std::size_t k = first_given_ ? 1 : 0; k < n_; ++k) {
    variable_[k] = count;
    const bool front = k == 0, back = k + 2 == n_ && ends_.to_stop;
    if (k + 1 < n_ && turns_behind(k)) scale_[k + 1] = scale_[k] * h[k + 1] / h[k];
    else if (!front && !back) ++count;
    if (front && !turns_behind(k)) scale_[0] = 1.0 / 3 / (1 + 2.0 / 3 * h[1] / h[0]);
    if (back && !turns_behind(k)) scale_[n_ - 1] = scale_[k] / 3 / (1 + 2.0 / 3 * h[n_ - 2] / h[n_ - 1]);
  }
  variables_ = variable_[n_ - 1] + 1;
}

void LeastTime::prepare() {
  const TimedPath& path = *path_;
  n_ = path.cells();
  knots_.assign(n_ + 1, {});
  for (std::size_t k = 1; k < n_; ++k) {
    const double before = path.h[k - 1], behind = path.h[k], sum = before + behind;
    knots_[k] = {behind / sum, before / sum, 2 / sum};
  }
  knots_[n_] = {1, 0, 0};  // crawling
  inverse_a_.resize(path.axes);
  inverse_j_.resize(path.axes);
  for (std::size_t a = 0; a < path.axes; ++a) {
    inverse_a_[a] = 1 / (margin * path.acceleration[a]);
    inverse_j_[a] = 1 / (margin * path.jerk[a]);
  }
  number_variables();
  m_.assign(n_ + 1, 0);
  if (first_given_) m_[0] = ends_.from.b + ends_.from.d * path.h[0] / 2;
  for (std::vector<double>* const all : {&y_, &trial_, &step_}) all->assign(variables_, 0);
  std::vector<double> most = path.most;
  if (!ends_.to_stop) most[n_ - 1] = std::min(most[n_ - 1], ends_.crawl);
  cap_.assign(variables_, infinite);
  for (std::size_t k = first_given_ ? 1 : 0; k < n_; ++k)
    cap_[variable_[k]] = std::min(cap_[variable_[k]], most[k] / scale_[k]);
  if (ends_.from_stop) keep_stop(0);
  if (ends_.to_stop) keep_stop(n_ - 1);
}

/// Jerk in the cell beside a stop, s⃛ = 2/9 b₁^(3/2) / h², as a limit of its variable: its middle is a third of b₁.
void LeastTime::keep_stop(std::size_t cell) {
  double most = infinite;  // of b₁
  for (std::size_t a = 0; a < path_->axes; ++a) {
    const double way = std::fabs(path_->x1[(cell * TimedPath::places + 1) * path_->axes + a]) * inverse_j_[a];
    if (way > 0) most = std::min(most, std::cbrt(square(4.5 * square(path_->h[cell]) / way)));
  }
  double& cap = cap_[variable_[cell]];
  cap = std::min(cap, most / (3 * scale_[cell]));
}

void LeastTime::spread(const std::vector<double>& y) {
  for (std::size_t k = first_given_ ? 1 : 0; k < n_; ++k) m_[k] = scale_[k] * y[variable_[k]];
}

PathSpeed LeastTime::start_of(std::size_t cell) const {
  if (cell == 0) return ends_.from_stop ? PathSpeed{} : ends_.from;
  if (turns_behind(cell - 1)) return {0, 2 * m_[cell] / path_->h[cell]};
  const Knot& at = knots_[cell];
  return {at.left * m_[cell - 1] + at.right * m_[cell], at.slope * (m_[cell] - m_[cell - 1])};
}

PathSpeed LeastTime::end_of(std::size_t cell) const {
  if (turns_behind(cell)) return {0, -2 * m_[cell] / path_->h[cell]};
  const Knot& at = knots_[cell + 1];
  return {at.left * m_[cell] + at.right * m_[cell + 1], at.slope * (m_[cell + 1] - m_[cell])};
}

LeastTime::By LeastTime::by_start(std::size_t cell, std::size_t first) const {
  By by;
  if (cell == 0) return by;
  const std::size_t here = variable_[cell] - first;
  if (turns_behind(cell - 1)) {
    by.d[here] = 2 * scale_[cell] / path_->h[cell];
    return by;
  }
  const Knot& at = knots_[cell];
  by.b[here] += at.right * scale_[cell];
  by.d[here] += at.slope * scale_[cell];
  if (cell == 1 && first_given_) return by;
  const std::size_t before = variable_[cell - 1] - first;
  by.b[before] += at.left * scale_[cell - 1];
  by.d[before] -= at.slope * scale_[cell - 1];
  return by;
}

LeastTime::By LeastTime::by_end(std::size_t cell, std::size_t first) const {
  By by;
  const bool given = cell == 0 && first_given_;
  const std::size_t here = given ? 0 : variable_[cell] - first;
  if (turns_behind(cell)) {
    if (!given) by.d[here] = -2 * scale_[cell] / path_->h[cell];
    return by;
  }
  const Knot& at = knots_[cell + 1];
  if (!given) by.b[here] += at.left * scale_[cell], by.d[here] -= at.slope * scale_[cell];
  if (cell + 1 == n_) return by;
  const std::size_t behind = variable_[cell + 1] - first;
  by.b[behind] += at.right * scale_[cell + 1];
  by.d[behind] += at.slope * scale_[cell + 1];
  return by;
}

double LeastTime::time() const {
  double sum = 0;
  for (std::size_t k = 0; k < n_; ++k) sum += path_->h[k] / std::sqrt(m_[k]);
  return sum;
}

/// T − μ Σ log(slack); infinite where a limit is not kept. A limit |x| ≤ 1 has the slack 1 − x². Leaves m_ as it is for y.
double LeastTime::barrier(const std::vector<double>& y, double mu) {
  const TimedPath& path = *path_;
  const std::size_t axes = path.axes;
  Logs logs;
  for (std::size_t v = 0; v < variables_; ++v) {
    if (!(y[v] > 0) || !(y[v] < cap_[v])) return infinite;
    logs.take(1 - y[v] / cap_[v]);
  }
  spread(y);
  for (std::size_t k = 0; k < n_; ++k) {
    if (is_stop_cell(k)) continue;
    const PathSpeed left = start_of(k), right = end_of(k);
    const double q = (right.d - left.d) / path.h[k];
    for (std::size_t place = 0; place < TimedPath::places; ++place) {
      const PathSpeed at = within(left, m_[k], right, TimedPath::part[place]);
      const std::size_t i = (k * TimedPath::places + place) * axes;
      for (std::size_t a = 0; a < axes; ++a) {
        const double x1 = path.x1[i + a] / 2, x2 = path.x2[i + a];
        const double acceleration = (x1 * at.d + x2 * at.b) * inverse_a_[a];
        const double jerk = (x1 * q + 1.5 * x2 * at.d + path.x3[i + a] * at.b) * inverse_j_[a];
        const double slack = 1 - square(acceleration), jerk_slack = 1 - at.b * square(jerk);
        if (!(slack > 0) || !(jerk_slack > 0)) return infinite;
        logs.take(slack * jerk_slack);
      }
    }
  }
  return time() - mu * logs.sum();
}

/// A limit |part| ≤ 1 with the derivatives `by`.
void LeastTime::add(std::size_t first, const Three& by, double part, double mu) {
  const double slack = 1 / (1 - part * part), slope = mu * 2 * part * slack, bend = mu * 2 * slack + slope * slope / mu;
  for (std::size_t i = 0; i < 3; ++i) gradient_[first + i] += slope * by[i];
  h0_[first] += bend * by[0] * by[0];
  h0_[first + 1] += bend * by[1] * by[1];
  h0_[first + 2] += bend * by[2] * by[2];
  h1_[first] += bend * by[0] * by[1];
  h1_[first + 1] += bend * by[1] * by[2];
  h2_[first] += bend * by[0] * by[2];
}

/// The limits within a cell.
void LeastTime::add_cell(std::size_t cell, double mu) {
  const bool given = cell == 0 && first_given_;
  const std::size_t first = cell <= 1 && first_given_ ? 0 : variable_[cell > 0 ? cell - 1 : 0];
  const By start = by_start(cell, first), stop = by_end(cell, first);
  const PathSpeed left = start_of(cell), right = end_of(cell);
  const double h = path_->h[cell], q = (right.d - left.d) / h;
  for (std::size_t place = 0; place < TimedPath::places; ++place) {
    const PathSpeed at = within(left, m_[cell], right, TimedPath::part[place]);
    const double part = TimedPath::part[place], rest = 1 - part, root = std::sqrt(at.b), half = at.b > 0 ? 0.5 / root : 0;
    By by;
    for (std::size_t j = 0; j < 3; ++j) {
      by.b[j] = rest * rest * start.b[j] + part * part * stop.b[j];
      by.d[j] = rest * start.d[j] + part * stop.d[j];
    }
    if (!given) by.b[variable_[cell] - first] += 2 * part * rest * scale_[cell];
    for (std::size_t a = 0; a < path_->axes; ++a) {
      const std::size_t i = (cell * TimedPath::places + place) * path_->axes + a;
      const double x1 = path_->x1[i] / 2, x2 = path_->x2[i], x3 = path_->x3[i];
      const double jerk = (x1 * q + 1.5 * x2 * at.d + x3 * at.b) * inverse_j_[a];
      Three by_a{}, by_j{};
      for (std::size_t j = 0; j < 3; ++j) {
        by_a[j] = (x1 * by.d[j] + x2 * by.b[j]) * inverse_a_[a];
        by_j[j] = root * (x1 * (stop.d[j] - start.d[j]) / h + 1.5 * x2 * by.d[j] + x3 * by.b[j]) * inverse_j_[a] + half * jerk * by.b[j];
      }
      add(first, by_a, (x1 * at.d + x2 * at.b) * inverse_a_[a], mu);
      add(first, by_j, root * jerk, mu);
    }
  }
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
  if (!ends_.guess.empty()) {
    for (std::size_t k = n_; k-- > (first_given_ ? 1 : 0);)
      y_[variable_[k]] = (k < ends_.guess.size() ? ends_.guess[k] : ends_.guess.back()) / scale_[k];
    if (std::isfinite(barrier(y_, 0))) return true;
  }
  if (!ends_.from_stop) return false;
  double least = infinite;
  for (std::size_t v = 0; v < variables_; ++v) least = std::min(least, cap_[v]);
  constexpr int most_tries = 60;
  for (int tries = 0; tries < most_tries; ++tries) {
    least /= 4;
    std::fill(y_.begin(), y_.end(), least);
    if (std::isfinite(barrier(y_, 0))) return true;
  }
  return false;
}

bool LeastTime::solve(const TimedPath& path, const Ends& ends) {
  constexpr double smaller = 0.2;      // μ, when its point is near
  constexpr double accurate = 2e-3;    // of the time: what μ may cost
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
  for (std::size_t k = 0; k < n_; ++k) speeds_[k] = {start_of(k), is_stop_cell(k) && k > 0 ? PathSpeed{} : end_of(k)};
  return true;
}

}  // namespace kadr
