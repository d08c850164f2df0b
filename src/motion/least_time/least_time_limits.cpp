// What a path's limits come to, before any speed is known: variables, linear forms, what each cell allows by itself.

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/least_time/least_time.h"

namespace kadr {
namespace {

constexpr double margin = 0.99, jerk_margin = 0.975;  // of the limits: between the places they are looked at they are a little exceeded
constexpr double infinite = std::numeric_limits<double>::infinity();

double square(double x) { return x * x; }

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
  number_variables();
  m_.assign(n_, 0);
  if (first_given_) m_[0] = ends_.from.b + ends_.from.d * path.h[0] / 2;
  for (std::vector<double>* const all : {&y_, &trial_}) all->assign(variables_, 0);
  step_.assign(variables_ + beyond, 0);
  find_mixes();
  find_moving();
  cap_.assign(variables_, infinite);
  // b in a cell lies between its middle and those of its neighbours, so a middle obeys the neighbours' limits too
  for (std::size_t k = first_given_ ? 1 : 0; k < n_; ++k) {
    double most = path.most[k];
    if (k > 0) most = std::min(most, path.most[k - 1]);
    if (k + 1 < n_) most = std::min(most, path.most[k + 1]);
    else if (!ends_.to_stop) most = std::min(most, ends_.crawl);
    cap_[variable_[k]] = std::min(cap_[variable_[k]], most / scale_[k]);
  }
  if (ends_.from_stop) keep_stop(0);
  if (ends_.to_stop) keep_stop(n_ - 1);
}

/// b at a knot lies on the line between the middle ordinates of its two cells; at a turn it is 0, and crawling it stays as it is.
void LeastTime::find_mixes() {
  mixes_.assign(n_, {});
  for (std::size_t k = 0; k < n_; ++k) {
    const std::size_t first = first_variable(k);
    const auto add = [&](Mix& mix, std::size_t cell, double part) {
      if (cell == 0 && first_given_) mix.given += part * m_[0];
      else mix.by[variable_[cell] - first] += part * scale_[cell];
    };
    const auto knot = [&](Mix& mix, std::size_t left) {
      const double before = path_->h[left], behind = path_->h[left + 1];
      add(mix, left, behind / (before + behind));
      add(mix, left + 1, before / (before + behind));
    };
    if (k > 0 && !turns_behind(k - 1)) knot(mixes_[k][0], k - 1);
    if (k == 0 && first_given_) mixes_[k][0].given = ends_.from.b;
    if (turns_behind(k)) continue;
    if (k + 1 < n_) knot(mixes_[k][1], k);
    else add(mixes_[k][1], k, 1);
  }
}

void LeastTime::find_moving() {
  const TimedPath& path = *path_;
  moving_.clear();
  for (std::size_t a = 0; a < path.axes; ++a) {
    bool moves = false;
    for (std::size_t k = 0; k < n_; ++k)
      for (std::size_t i = (k * path.axes + a) * places, end = i + places; i < end; ++i)
        moves = moves || path.x1[i] != 0 || path.x2[i] != 0;
    if (moves) moving_.push_back({a, 1 / (margin * path.acceleration[a]), 1 / (jerk_margin * path.jerk[a])});
  }
}

/// In the cell beside a stop, at the part τ of it from there: b = b₁ τ^(4/3), so ṡ s̈ = ±2/3 τ b₁^(3/2) / h, s⃛ = 2/9 b₁^(3/2) / h². What
/// that comes to as a limit of its variable: its middle is a third of b₁.
void LeastTime::keep_stop(std::size_t cell) {
  const TimedPath& path = *path_;
  const double h = path.h[cell], ahead = cell == 0 ? 1 : -1;  // the stop is before it, or after
  double most = infinite;                                     // of b₁
  for (std::size_t a = 0; a < path.axes; ++a)
    for (std::size_t p = 0; p < places; ++p) {
      const std::size_t i = (cell * path.axes + a) * places + p;
      const double part = cell == 0 ? TimedPath::part[p] : 1 - TimedPath::part[p];
      const double jerk = 2.0 / 9 * path.x1[i] / (h * h) + ahead * 2 * path.x2[i] * part / h + path.x3[i] * square(part);
      const double acceleration = ahead * 2.0 / 3 * path.x1[i] / h * std::cbrt(part) + path.x2[i] * part * std::cbrt(part);
      if (jerk != 0) most = std::min(most, std::cbrt(square(jerk_margin * path.jerk[a] / jerk)));
      if (acceleration != 0) most = std::min(most, margin * path.acceleration[a] / std::fabs(acceleration));
    }
  double& cap = cap_[variable_[cell]];
  cap = std::min(cap, most / (3 * scale_[cell]));
}

/// What a cell allows by itself, ṡ².
double LeastTime::alone(const TimedPath& path, std::size_t cell) {
  constexpr double none = 1e-12;  // a derivative of this size limits nothing
  double most = path.most[cell];
  for (std::size_t a = 0; a < path.axes; ++a)
    for (std::size_t i = (cell * path.axes + a) * places, end = i + places; i < end; ++i) {
      most = std::min(most, path.acceleration[a] / std::max(std::fabs(path.x2[i]), none));
      most = std::min(most, std::cbrt(square(path.jerk[a] / std::max(std::fabs(path.x3[i]), none))));
    }
  return most;
}

double LeastTime::slowest(const TimedPath& path) {
  double least = infinite;
  for (std::size_t k = 0; k < path.cells(); ++k) least = std::min(least, alone(path, k));
  return least;
}

/// d b^(3/4) / ds with constant jerk from rest: b = (6^(4/3)/4) j^(2/3) s^(4/3).
double LeastTime::soonest() const {
  double least = infinite;
  for (std::size_t a = 0; a < path_->axes; ++a) least = std::min(least, 2.12 * std::sqrt(path_->jerk[a]));
  return least;
}

/// About how fast the path may be passed, into m_: by what each cell allows by itself, and by how soon jerk lets it get there.
void LeastTime::find_envelope() {
  const double soonest = this->soonest();
  double reached = 0;  // b^(3/4)
  for (std::size_t k = 0; k < n_; ++k) {
    const double most = alone(*path_, k);
    reached = k > 0 && turns_behind(k - 1) ? 0 : reached;
    reached = std::min(std::pow(most, 0.75), reached + soonest * path_->h[k]);
    m_[k] = reached;
  }
  reached = ends_.to_stop ? 0 : m_[n_ - 1];
  for (std::size_t k = n_; k-- > 0;) {
    if (turns_behind(k)) reached = 0;
    m_[k] = reached = std::min(m_[k], reached + soonest * path_->h[k]);
  }
  constexpr int rounds = 8;
  for (int round = 0; round < rounds; ++round)  // its corners are rounded
    for (std::size_t k = 1; k + 1 < n_; ++k)
      if (!turns_behind(k) && !turns_behind(k - 1)) m_[k] = (m_[k - 1] + 2 * m_[k] + m_[k + 1]) / 4;
  for (double& m : m_) m = std::pow(m, 4.0 / 3);
}

}  // namespace kadr
