#include "motion/least_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kadr {
namespace {

constexpr double margin = 0.995;  // of acceleration and jerk: between the knots they are a little higher
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
}

/// A cell beside a stop has b = b₁ (σ/h)^(4/3), so that at its inner knot b′ = 4/3 b₁/h: its middle is a third of b₁.
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
  for (std::vector<double>* const all : {&trial_, &step_, &m_}) all->assign(n_ + 1, 0);
  cap_ = path.most;
  first_ = 1;
  last_ = ends_.to_stop ? n_ - 1 : n_;
  tie_front_ = 1.0 / 3 / (1 + 2.0 / 3 * path.h[1] / path.h[0]);
  tie_back_ = 1.0 / 3 / (1 + 2.0 / 3 * path.h[n_ - 2] / path.h[n_ - 1]);
  if (ends_.from_stop) keep_stop(0, 1, tie_front_);
  if (ends_.to_stop) keep_stop(n_ - 1, n_ - 2, tie_back_);
  else cap_[n_ - 1] = std::min(cap_[n_ - 1], ends_.crawl);
}

/// Jerk in the cell beside a stop, s⃛ = 2/9 b₁^(3/2) / h², as a limit of its neighbour's middle.
void LeastTime::keep_stop(std::size_t cell, std::size_t inner, double tie) {
  double most = infinite;  // of b₁
  for (std::size_t a = 0; a < path_->axes; ++a) {
    const double way = std::fabs(path_->x1[(cell * TimedPath::places + 1) * path_->axes + a]) * inverse_j_[a];
    if (way > 0) most = std::min(most, std::cbrt(square(4.5 * square(path_->h[cell]) / way)));
  }
  cap_[inner] = std::min(cap_[inner], most / (3 * tie));
}

void LeastTime::tie(std::vector<double>& m) const {
  if (ends_.from_stop) m[0] = tie_front_ * m[1];
  if (ends_.to_stop) m[n_ - 1] = tie_back_ * m[n_ - 2];
}

PathSpeed LeastTime::speed_at(std::size_t knot, const std::vector<double>& m) const {
  if (knot == 0) return ends_.from_stop ? PathSpeed{} : ends_.from;
  const Knot& at = knots_[knot];
  return {at.left * m[knot - 1] + at.right * m[knot], at.slope * (m[knot] - m[knot - 1])};
}

double LeastTime::time() const {
  double sum = 0;
  for (std::size_t k = first_; k < last_; ++k) sum += path_->h[k] / std::sqrt(m_[k]);
  return sum;
}

/// T − μ Σ log(slack); infinite where a limit is not kept. A limit |x| ≤ 1 has the slack 1 − x².
double LeastTime::barrier(const std::vector<double>& m, double mu) const {
  const TimedPath& path = *path_;
  const std::size_t axes = path.axes;
  double time = 0;
  Logs logs;
  for (std::size_t k = first_; k < last_; ++k) {
    if (!(m[k] > 0) || !(m[k] < cap_[k])) return infinite;
    time += path.h[k] / std::sqrt(m[k]);
    logs.take(1 - m[k] / cap_[k]);
  }
  PathSpeed left = speed_at(0, m);
  for (std::size_t k = 0; k < last_; ++k) {
    const PathSpeed right = speed_at(k + 1, m);
    if (!is_stop_cell(k)) {
      const double q = (right.d - left.d) / path.h[k];
      for (std::size_t place = 0; place < TimedPath::places; ++place) {
        const PathSpeed at = within(left, m[k], right, TimedPath::part[place]);
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
    left = right;
  }
  return time - mu * logs.sum();
}

/// A limit |part| ≤ 1 with the derivatives `by`.
void LeastTime::add(std::size_t first, const Four& by, double part, double mu) {
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
  const std::size_t first = std::min(cell > 0 ? cell - 1 : 0, n_ - 3), here = cell - first;
  const Knot& before = knots_[cell];
  const Knot& behind = knots_[cell + 1];
  const PathSpeed left = speed_at(cell, m_), right = speed_at(cell + 1, m_);
  const double h = path_->h[cell], q = (right.d - left.d) / h;
  Four b0{}, d0{}, b1{}, d1{}, dq{};  // of b and b′ at the ends, of b″
  if (cell > 0) b0[here - 1] = before.left, b0[here] = before.right, d0[here - 1] = -before.slope, d0[here] = before.slope;
  b1[here] = behind.left, b1[here + 1] = behind.right, d1[here] = -behind.slope, d1[here + 1] = behind.slope;
  for (std::size_t j = 0; j < 3; ++j) dq[j] = (d1[j] - d0[j]) / h;
  for (std::size_t place = 0; place < TimedPath::places; ++place) {
    const PathSpeed at = within(left, m_[cell], right, TimedPath::part[place]);
    const double root = std::sqrt(at.b), half = 0.5 / root, part = TimedPath::part[place], rest = 1 - part;
    Four db{}, dd{};
    for (std::size_t j = 0; j < 3; ++j) {
      db[j] = rest * rest * b0[j] + (j == here ? 2 * part * rest : 0) + part * part * b1[j];
      dd[j] = rest * d0[j] + part * d1[j];
    }
    for (std::size_t a = 0; a < path_->axes; ++a) {
      const std::size_t i = (cell * TimedPath::places + place) * path_->axes + a;
      const double x1 = path_->x1[i] / 2, x2 = path_->x2[i], x3 = path_->x3[i];
      const double jerk = (x1 * q + 1.5 * x2 * at.d + x3 * at.b) * inverse_j_[a];
      Four by_a{}, by_j{};
      for (std::size_t j = 0; j < 3; ++j) {
        by_a[j] = (x1 * dd[j] + x2 * db[j]) * inverse_a_[a];
        by_j[j] = root * (x1 * dq[j] + 1.5 * x2 * dd[j] + x3 * db[j]) * inverse_j_[a] + half * jerk * db[j];
      }
      add(first, by_a, (x1 * at.d + x2 * at.b) * inverse_a_[a], mu);
      add(first, by_j, root * jerk, mu);
    }
  }
}

/// Gradient and Hessian of the barrier at m_.
void LeastTime::derivatives(double mu) {
  for (std::vector<double>* const all : {&gradient_, &h0_, &h1_, &h2_}) all->assign(n_ + 1, 0);
  for (std::size_t k = first_; k < last_; ++k) {
    const double root = std::sqrt(m_[k]), slack = 1 / (cap_[k] - m_[k]);
    gradient_[k] += -0.5 * path_->h[k] / (m_[k] * root) + mu * slack;
    h0_[k] += 0.75 * path_->h[k] / (m_[k] * m_[k] * root) + mu * slack * slack;
  }
  for (std::size_t k = 0; k < last_; ++k)
    if (!is_stop_cell(k)) add_cell(k, mu);
  fold_ties();
}

void LeastTime::fold_ties() {
  if (ends_.from_stop) {  // m_0 = tie m_1
    const double t = tie_front_;
    gradient_[1] += t * gradient_[0];
    h0_[1] += 2 * t * h1_[0] + t * t * h0_[0];
    h1_[1] += t * h2_[0];
  }
  if (!ends_.to_stop) return;
  const double t = tie_back_;
  gradient_[n_ - 2] += t * gradient_[n_ - 1];
  h0_[n_ - 2] += 2 * t * h1_[n_ - 2] + t * t * h0_[n_ - 1];
  h1_[n_ - 3] += t * h2_[n_ - 3];
}

/// H · step_ = −gradient_, by L D Lᵀ of five diagonals; L stays in h1_ and h2_, D in h0_.
///   returns  false: H is not positive
bool LeastTime::newton_step() {
  for (std::size_t i = first_; i < last_; ++i) {
    double d = h0_[i], z = -gradient_[i];
    if (i >= first_ + 2) {
      const double l = h2_[i - 2] / h0_[i - 2];
      d -= l * h2_[i - 2];
      h1_[i - 1] -= l * h1_[i - 2] * h0_[i - 2];  // h1_[i − 2] is L by now
      z -= l * step_[i - 2];
      h2_[i - 2] = l;
    }
    if (i >= first_ + 1) {
      const double l = h1_[i - 1] / h0_[i - 1];
      d -= l * h1_[i - 1];
      z -= l * step_[i - 1];
      h1_[i - 1] = l;
    }
    if (!(d > 0) || !std::isfinite(d)) return false;
    h0_[i] = d;
    step_[i] = z;
  }
  for (std::size_t i = last_; i-- > first_;) {
    double x = step_[i] / h0_[i];
    if (i + 1 < last_) x -= h1_[i] * step_[i + 1];
    if (i + 2 < last_) x -= h2_[i] * step_[i + 2];
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
  for (std::size_t k = first_; k < last_; ++k) {
    falls -= gradient_[k] * step_[k];
    if (step_[k] < 0) part = std::min(part, -0.95 * m_[k] / step_[k]);
  }
  trial_ = m_;
  for (int halved = 0; halved < most_halvings; ++halved, part *= 0.5) {
    for (std::size_t k = first_; k < last_; ++k) trial_[k] = m_[k] + part * step_[k];
    tie(trial_);
    if (!(barrier(trial_, mu) <= value - enough * part * falls)) continue;
    std::swap(m_, trial_);
    return falls;
  }
  return 0;
}

/// A speed that obeys all limits: an earlier solution that crawls on behind its end, or one so low that all limits are far away.
bool LeastTime::first_guess() {
  if (!ends_.from_stop) m_[0] = ends_.from.b + ends_.from.d * path_->h[0] / 2;
  if (!ends_.guess.empty()) {
    for (std::size_t k = first_; k < n_; ++k) m_[k] = k < ends_.guess.size() ? ends_.guess[k] : ends_.guess.back();
    tie(m_);
    if (std::isfinite(barrier(m_, 0))) return true;
  }
  if (!ends_.from_stop) return false;
  double least = infinite;
  for (std::size_t k = first_; k < last_; ++k) least = std::min(least, cap_[k]);
  constexpr int most_tries = 60;
  for (int tries = 0; tries < most_tries; ++tries) {
    least /= 4;
    std::fill(m_.begin(), m_.end(), least);
    tie(m_);
    if (std::isfinite(barrier(m_, 0))) return true;
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
    const double falls = line_search(barrier(m_, mu), mu);
    if (falls >= near_enough * mu * conditions) continue;
    const double now = time();
    if (mu * conditions < accurate * now || falls == 0) break;
    mu = std::min(mu, now / conditions) * smaller;
  }
  speeds_.resize(n_ + 1);
  for (std::size_t k = 0; k <= n_; ++k) speeds_[k] = speed_at(k, m_);
  if (ends_.to_stop) speeds_[n_] = {};
  return true;
}

}  // namespace kadr
